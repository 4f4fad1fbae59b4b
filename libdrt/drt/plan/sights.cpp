#include "drt/plan/sights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/plan/explain.h"

namespace drt {

namespace {

// The area that a light shows to the eye, if nothing is in the way, and the square of its distance.
struct Appearance {
    double area = 0, distance2 = 0;
};

Appearance seen_from(const Vec3d& eye, const SphereLight& l) {
    return {pi<double> * l.radius * l.radius, dot(l.center - eye, l.center - eye)};
}

Appearance seen_from(const Vec3d& eye, const RectLight& l) {
    const Vec3d v = l.corner + (l.edge_x + l.edge_y) * 0.5 - eye;
    const double d2 = dot(v, v);
    return {d2 > 0 ? std::abs(dot(cross(l.edge_x, l.edge_y), v)) / std::sqrt(d2) : 0, d2};
}

Appearance seen_from(const Vec3d&, const PointLight&) { return {}; }

VisibleSource make_source(const Light& light, const PreparedScene& p) {
    const Appearance a = std::visit([&](const auto& shape) { return seen_from(p.origin, shape); }, light.shape);
    const double side = view_at(p.camera, 0.0).pixel_size;
    return {max_component(light.color), a.area / std::max(a.distance2 * side * side, 1e-300)};
}

}  // namespace

Sights find_sights(const SceneDesc& scene, const PreparedScene& p) {
    Sights s;
    for (const Light& l : scene.lights)
        if (l.visible) s.sources.push_back(make_source(l, p));
    float surface = 0;
    for (const Material& m : scene.materials)
        surface = std::max(surface, max_component(m.ambient * scene.ambient_light));
    // Every surface on the way adds its ambient term; what shines otherwise ends the path.
    const double share = largest_share(scene), depth = scene.render.max_depth;
    s.by_scattering = depth > 0 && share > 0;
    s.gain = std::pow(std::max(1.0, share), depth);
    const double surfaces = share == 1 ? depth + 1 : (1 - std::pow(share, depth + 1)) / (1 - share);
    s.glow = max_component(scene.background) * s.gain + (surface > 0 ? surface * surfaces : 0);
    return s;
}

}  // namespace drt
