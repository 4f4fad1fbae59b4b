#include "support/plant_faults.h"

#include <cmath>
#include <numbers>

namespace drt {

void brighten_lights(SceneDesc& scene, float factor) {
    for (Light& light : scene.lights) light.color *= factor;
}

void widen_lobes(SceneDesc& scene, double factor) {
    for (Material& m : scene.materials) {
        m.reflection_spread_degrees *= factor;
        m.refraction_spread_degrees *= factor;
    }
}

void shift_filter(SceneDesc& scene, double pixels) {
    for (Camera& camera : scene.cameras) {
        const double pixel = 2 * std::tan(camera.fov_degrees_start * std::numbers::pi / 360) / scene.render.width;
        const Vec3d view = camera.targets[0] - camera.positions[0];
        camera.targets[0] += normalize(cross(view, camera.up_start)) * (pixels * pixel * length(view));
    }
}

}  // namespace drt
