// Textures and materials.
#include <algorithm>
#include <filesystem>

#include "drt/base/constants.h"
#include "drt/formats/legacy_map.h"

namespace drt {
namespace {

Color to_color(const Vec3d& v) { return {float(v.x), float(v.y), float(v.z)}; }

void map_texture(LegacyMapping& m, size_t index) {
    const LegacyElement& e = m.elements[index];
    std::string file(e.word("file"));
    std::ranges::replace(file, '\\', '/');  // the 2008 program ran on Windows
    Texture t;
    t.name = m.names.name(index);
    t.file = (std::filesystem::path(m.directory) / file).lexically_normal().string();
    const std::string path = "textures[" + std::to_string(m.scene.textures.size()) + ']';
    m.mark(path, e.place);
    m.mark(path + ".name", e.name_place);
    m.mark(path + ".file", e, "file");
    m.scene.textures.push_back(std::move(t));
}

void map_phong(LegacyMapping& m, const LegacyElement& e, const std::string& path, Material& out) {
    out.ambient = to_color(e.vector("ambient"));
    out.diffuse = to_color(e.vector("diffuse"));
    out.specular = to_color(e.vector("specular"));
    out.shininess = e.real("shininess");
    out.reflectance = e.real("reflectance");
    if (m.effects.glossy_reflection) out.reflection_spread_degrees = degrees(e.real("diffuse_reflection"));
    out.refraction = e.real("refraction");
    if (m.effects.glossy_refraction) out.refraction_spread_degrees = degrees(e.real("diffuse_refraction"));
    out.refraction_index = e.real("refraction_index");
    for (const char* same :
         {"ambient", "diffuse", "specular", "shininess", "reflectance", "refraction", "refraction_index"})
        m.mark(path + '.' + same, e, same);
    m.mark(path + ".reflection_spread_degrees", e, "diffuse_reflection");
    m.mark(path + ".refraction_spread_degrees", e, "diffuse_refraction");
}

void map_material(LegacyMapping& m, size_t index) {
    const LegacyElement& e = m.elements[index];
    const std::string path = "materials[" + std::to_string(m.scene.materials.size()) + ']';
    Material out;
    out.name = m.names.name(index);
    m.mark(path, e.place);
    m.mark(path + ".name", e.name_place);
    if (const auto phong = m.names.resolve(index, "phong_info", m.report)) map_phong(m, m.elements[*phong], path, out);
    if (e.type->kind == LegacyKind::material_texture) {
        if (const auto texture = m.names.resolve(index, "texture", m.report)) out.texture = m.names.name(*texture);
        out.scale_u = e.real("scale_U");
        out.scale_v = e.real("scale_V");
        m.mark(path + ".texture", e, "texture");
        m.mark(path + ".scale_u", e, "scale_U");
        m.mark(path + ".scale_v", e, "scale_V");
    }
    if (out.name != e.name) m.report.note(e.name_place, "renamed to " + out.name + ": another material has this name");
    m.scene.materials.push_back(std::move(out));
}

}  // namespace

void map_legacy_materials(LegacyMapping& m) {
    for (size_t i = 0; i < m.elements.size(); ++i) {
        const LegacyKind kind = m.elements[i].type->kind;
        if (kind == LegacyKind::texture) map_texture(m, i);
        if (kind == LegacyKind::material_phong || kind == LegacyKind::material_texture) map_material(m, i);
    }
}

}  // namespace drt
