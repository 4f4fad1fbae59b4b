#include "drt/scene/preview.h"

#include "drt/base/constants.h"

namespace drt {
namespace {

struct PointEquivalent {
    Vec3d center;
    double area = 1;  ///< that the light shows head-on
};

PointEquivalent equivalent(const PointLight& l) { return {l.position, 1}; }
PointEquivalent equivalent(const RectLight& l) {
    return {l.corner + l.edge_x * 0.5 + l.edge_y * 0.5, length(cross(l.edge_x, l.edge_y))};
}
PointEquivalent equivalent(const SphereLight& l) { return {l.center, pi<double> * l.radius * l.radius}; }

}  // namespace

SceneDesc without_distributed_effects(SceneDesc scene) {
    for (Light& light : scene.lights) {
        const PointEquivalent e = std::visit([](const auto& shape) { return equivalent(shape); }, light.shape);
        light.shape = PointLight{e.center};
        if (light.falloff == Light::Falloff::inverse_square) light.color *= float(e.area);
        light.visible = false;
    }
    for (Camera& camera : scene.cameras) {
        camera.lens.aperture_radius = 0;
        camera.shutter.duration = 0;
    }
    for (Material& material : scene.materials) {
        material.reflection_spread_degrees = 0;
        material.refraction_spread_degrees = 0;
    }
    scene.render.filter.kind = Filter::Kind::point;
    scene.render.spp = 1;
    return scene;
}

}  // namespace drt
