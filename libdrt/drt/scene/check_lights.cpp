#include "drt/scene/check_fields.h"

namespace drt {
namespace {

void check_shape(Report& report, const ScenePath& at, const FineFields&, const Light& light, const PointLight&) {
    if (light.visible)
        report.error(at / "visible", "a point light cannot be seen", "true", "false, or a small light of type sphere");
}

void check_shape(Report& report, const ScenePath& at, const FineFields& fine, const Light& light, const RectLight& r) {
    if (fine(at / "edge_x", at / "edge_y") && nearly_parallel(r.edge_x, r.edge_y))
        report.error(
            at / "edge_y", "light without area", to_text(r.edge_y),
            "an edge that is not parallel to " + report.name(at / "edge_x", "edge_x") + ' ' + to_text(r.edge_x));
    if (r.two_sided && light.falloff == Light::Falloff::none)
        report.warning(at / "two_sided", "two_sided has no effect with falloff none");
}

void check_shape(Report&, const ScenePath&, const FineFields&, const Light&, const SphereLight&) {}

}  // namespace

void check_lights(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "lights";
    check_unique_names(report, list, scene.lights);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const ScenePath at = list[i];
        const FineFields fine = check_fields(report, at, light);
        std::visit([&](const auto& shape) { check_shape(report, at, fine, light, shape); }, light.shape);
        if (light.visible && light.falloff == Light::Falloff::none && !std::holds_alternative<PointLight>(light.shape))
            report.error(at / "visible", "a light with falloff none has no radiance to be seen", "true",
                         "false, or falloff: inverse_square");
    }
    if (scene.lights.empty() && is_black(scene.ambient_light))
        report.warning(list, "the scene has no lights and no ambient_light: bodies will be black");
}

}  // namespace drt
