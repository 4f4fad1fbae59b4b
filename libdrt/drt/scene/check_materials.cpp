#include "drt/scene/check_fields.h"

namespace drt {
namespace {

void check_texture_reference(Report& report, const ScenePath& at, const SceneDesc& scene, const Material& material) {
    if (material.texture.empty()) return;
    std::vector<std::string_view> names;
    for (const Texture& t : scene.textures) {
        if (t.name == material.texture) return;
        names.push_back(t.name);
    }
    report.error(at / "texture", "unknown texture", material.texture,
                 names.empty() ? "a texture of this scene, which has none" : "the name of a texture",
                 nearest_word(material.texture, names));
}

void check_energy(Report& report, const ScenePath& at, const Material& m) {
    const double sum = m.reflectance + m.refraction;
    if (sum > 1)
        report.warning(at / "reflectance", "reflectance + refraction gives out more light than comes in", to_text(sum),
                       "at most 1");
    if (max_component(m.diffuse) > 1)
        report.warning(at / "diffuse", "diffuse gives out more light than comes in", to_text(m.diffuse),
                       "components of at most 1");
}

}  // namespace

void check_materials(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "materials";
    check_unique_names(report, list, scene.materials);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
        if (check_fields(report, list[i], scene.materials[i])) check_energy(report, list[i], scene.materials[i]);
        check_texture_reference(report, list[i], scene, scene.materials[i]);
    }
}

}  // namespace drt
