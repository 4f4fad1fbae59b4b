#include "drt/plan/brightest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drt {

namespace {

// The largest share of the light that a material sends on.
double largest_share(const SceneDesc& scene) {
    double share = 0;
    for (const Material& m : scene.materials) share = std::max(share, double(m.reflectance) + double(m.refraction));
    return share;
}

}  // namespace

float brightest_sight(const SceneDesc& scene, const PreparedScene& p) {
    // Every surface on the way adds its ambient term; what shines otherwise ends the path.
    float end = max_component(scene.background), surface = 0;
    for (const Emitter& e : p.emitters) end = std::max(end, max_component(e.radiance));
    for (const Material& m : scene.materials)
        surface = std::max(surface, max_component(m.ambient * scene.ambient_light));
    const double share = largest_share(scene), depth = scene.render.max_depth;
    const double reflected = share == 1 ? depth + 1 : (1 - std::pow(share, depth + 1)) / (1 - share);
    const double brightest = end * std::pow(std::max(1.0, share), depth) + surface * reflected;
    constexpr double largest = std::numeric_limits<float>::max();
    return float(brightest < largest ? brightest : largest);  // also if it is infinite times 0
}

bool brightens(const SceneDesc& scene) { return scene.render.max_depth > 0 && largest_share(scene) > 1; }

}  // namespace drt
