#include "drt/scene/check_fields.h"

namespace drt {
namespace {

void check_energy(Report& report, const ScenePath& at, const Material& m, const FineFields& fine) {
    const double sum = m.reflectance + m.refraction;
    if (fine(at / "reflectance", at / "refraction") && sum > 1)
        report.warning(at / "reflectance", "reflectance + refraction gives out more light than comes in", to_text(sum),
                       "at most 1");
    if (fine(at / "diffuse") && max_component(m.diffuse) > 1)
        report.warning(at / "diffuse", "diffuse gives out more light than comes in", to_text(m.diffuse),
                       "components of at most 1");
}

}  // namespace

void check_materials(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "materials";
    check_unique_names(report, list, scene.materials);
    const NameIndex textures(scene.textures);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        const FineFields fine = check_fields(report, list[i], scene.materials[i]);
        check_energy(report, list[i], scene.materials[i], fine);
        const std::string& texture = scene.materials[i].texture;
        if (!texture.empty()) textures.find(report, list[i] / "texture", texture);
    }
}

}  // namespace drt
