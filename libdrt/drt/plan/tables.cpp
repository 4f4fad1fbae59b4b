#include "drt/plan/tables.h"

#include <fmt/format.h>

#include <set>
#include <unordered_map>

#include "drt/plan/texture_cache.h"
#include "drt/scene/scene_fields.h"

namespace drt {

static_assert(largest_depth < most_bounces, "each bounce has sample dimensions of its own");

namespace {

FilterTable build_filter(const Filter& f) {
    const auto kind = [&] {
        switch (f.kind) {
            case Filter::Kind::point:
                return FilterKind::point;
            case Filter::Kind::box:
                return FilterKind::box;
            case Filter::Kind::triangle:
                return FilterKind::triangle;
            case Filter::Kind::gaussian:
                return FilterKind::gaussian;
            case Filter::Kind::blackman_harris:
                return FilterKind::blackman_harris;
            case Filter::Kind::mitchell:
                return FilterKind::mitchell;
        }
        return FilterKind::point;
    }();
    return make_filter({kind, f.radius, f.sigma});
}

ReadOptions::Transfer transfer_of(Texture::ColorSpace c) {
    switch (c) {
        case Texture::ColorSpace::automatic:
            return ReadOptions::Transfer::automatic;
        case Texture::ColorSpace::srgb:
            return ReadOptions::Transfer::srgb;
        case Texture::ColorSpace::linear:
            return ReadOptions::Transfer::linear;
    }
    return ReadOptions::Transfer::automatic;
}

// Textures that some body wears; their number in SceneTables::textures, by name.
using TextureIndex = std::unordered_map<std::string, int>;

Diagnostic unreadable(const SceneDesc& scene, size_t i, const std::string& problem, bool checker_stands_in) {
    const Location place = scene.sources.find(fmt::format("textures[{}].file", i));
    const std::string what = fmt::format("texture \"{}\": {}", scene.textures[i].name, problem);
    if (checker_stands_in) return {Severity::warning, place, what + " (a checker stands in)", {}, {}, {}};
    return {Severity::error, place, what, {}, "an image file (--missing-textures checker renders without)", {}};
}

TextureIndex load_textures(const SceneDesc& scene, const PlanOptions& options, TextureCache& cache, SceneTables& tables,
                           Diagnostics& notes) {
    std::set<std::string> materials, wanted;
    for (const Body& b : scene.bodies) materials.insert(b.material);
    for (const Material& m : scene.materials)
        if (materials.contains(m.name)) wanted.insert(m.texture);
    const bool checker = options.checker_for_missing_textures;
    TextureIndex index;
    Diagnostics errors;
    for (size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& t = scene.textures[i];
        if (!wanted.contains(t.name)) continue;
        const TextureCache::Entry& texture = cache.get(t.file, transfer_of(t.color_space));
        index.emplace(t.name, int(tables.textures.maps.size()));
        tables.textures.maps.push_back(texture.map);
        if (!texture.problem.empty())
            (checker ? notes : errors).push_back(unreadable(scene, i, texture.problem, checker));
    }
    if (!errors.empty()) throw Error(ErrorKind::asset, std::move(errors));
    return index;
}

int lobe_id(LobeTables& lobes, double spread_degrees) {
    return spread_degrees > 0 ? add_lobe(lobes, radians(spread_degrees)) : sharp;
}

void add_material(MaterialTable& t, const Material& m, const Color& ambient_light, const TextureIndex& textures) {
    t.ambient.push_back(m.ambient * ambient_light);
    t.diffuse.push_back(m.diffuse);
    t.specular.push_back(m.specular);
    t.shininess.push_back(float(m.shininess));
    t.reflectance.push_back(float(m.reflectance));
    t.refraction.push_back(float(m.refraction));
    t.refraction_index.push_back(float(m.refraction_index));
    t.reflection_lobe.push_back(lobe_id(t.lobes, m.reflection_spread_degrees));
    t.refraction_lobe.push_back(lobe_id(t.lobes, m.refraction_spread_degrees));
    const auto texture = textures.find(m.texture);
    t.texture.push_back(texture == textures.end() ? no_texture : texture->second);
    t.inv_scale_u.push_back(float(1 / m.scale_u));
    t.inv_scale_v.push_back(float(1 / m.scale_v));
}

}  // namespace

SceneTables build_tables(const SceneDesc& scene, const PlanOptions& options, const Features& features,
                         TextureCache& cache, Diagnostics& notes) {
    SceneTables tables;
    tables.filter = build_filter(scene.render.filter);
    TextureIndex textures;
    if (features.textures) textures = load_textures(scene, options, cache, tables, notes);
    tables.materials.ambient_light = scene.ambient_light;
    for (const Material& m : scene.materials) add_material(tables.materials, m, scene.ambient_light, textures);
    if (scene.materials.empty()) add_material(tables.materials, Material{}, scene.ambient_light, {});  // never read
    return tables;
}

}  // namespace drt
