#include "drt/plan/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "drt/light/light_tree.h"

namespace drt {

namespace {

// Materials that some body wears: the others cannot matter.
std::vector<const Material*> used_materials(const SceneDesc& scene, const PreparedScene& p) {
    const std::set<int> used(p.body_material.begin(), p.body_material.end());
    std::vector<const Material*> out;
    for (const int m : used)
        if (m >= 0) out.push_back(&scene.materials[size_t(m)]);
    return out;
}

int count_moving(const PreparedScene& p) {
    return int(std::count_if(p.bodies.begin(), p.bodies.end(), [](const BodyInput& b) { return !b.path.empty(); }));
}

int count_refracting(const PreparedScene& p) {
    return int(std::count_if(p.bodies.begin(), p.bodies.end(), [](const BodyInput& b) { return b.role.refracts; }));
}

}  // namespace

double largest_share(const SceneDesc& scene) {
    double share = 0;
    for (const Material& m : scene.materials) share = std::max(share, double(m.reflectance) + double(m.refraction));
    return share;
}

bool shows_background(const SceneDesc& scene) {
    return !scene.render.transparent_background && !is_black(scene.background);
}

Features find_features(const SceneDesc& scene, const PreparedScene& p) {
    const auto materials = used_materials(scene, p);
    const auto any = [&](auto predicate) { return std::any_of(materials.begin(), materials.end(), predicate); };
    Features f;
    f.pixel_filter = scene.render.filter.kind != Filter::Kind::point;
    f.lens = p.camera.lens.radius > 0;
    f.moving_camera = p.camera.moving;
    f.time = f.moving_camera || count_moving(p) > 0;
    f.planes = std::any_of(p.bodies.begin(), p.bodies.end(),
                           [](const BodyInput& b) { return std::holds_alternative<PlaneShape<double>>(b.shape); });
    f.textures = std::any_of(p.body_mapping.begin(), p.body_mapping.end(), [](int m) { return m >= 0; });
    f.visible_lights = !p.emitters.empty();
    f.lights = p.lights.count() > 0;
    f.light_samples = !p.lights.rects.empty() || !p.lights.spheres.empty();
    f.light_tree = !p.lights.tree.empty();
    f.specular = f.lights && any([](const Material* m) { return !is_black(m->specular); });
    const bool deep = scene.render.max_depth > 0;
    f.refraction = deep && any([](const Material* m) { return m->refraction > 0; });
    f.scatter = f.refraction || (deep && any([](const Material* m) { return m->reflectance > 0; }));
    f.nested_media = f.refraction && count_refracting(p) > 1;
    f.eye_media = f.refraction && !p.eye_media.empty();
    f.glossy = deep && any([](const Material* m) {
                   return (m->reflectance > 0 && m->reflection_spread_degrees > 0) ||
                          (m->refraction > 0 && m->refraction_spread_degrees > 0);
               });
    f.lobe_lights =
        deep && any([](const Material* m) { return m->reflectance > 0 && m->reflection_spread_degrees > 0; }) &&
        std::any_of(p.emitters.begin(), p.emitters.end(), [](const Emitter& e) { return e.light != no_light; });
    f.brightens = deep && largest_share(scene) > 1;
    return f;
}

bool draws_samples(const Features& f, const PreparedScene& p) {
    return f.pixel_filter || f.lens || f.time || f.light_samples || f.scatter ||
           int(p.lights.asked.size()) < p.lights.count();
}

Features keep_everything(Features f) {
    f.pixel_filter = f.lens = f.time = f.moving_camera = f.planes = f.textures = true;
    f.visible_lights = f.lights = f.light_samples = f.specular = true;
    f.scatter = f.refraction = f.nested_media = f.eye_media = f.glossy = f.lobe_lights = f.brightens = true;
    return f;
}

Explanation explain(const SceneDesc& scene, const PreparedScene& p, const Features& f,
                    const std::string& double_reason) {
    Explanation out;
    const auto say = [&](std::string what, bool kept, std::string yes, std::string no) {
        out.push_back({std::move(what), kept, kept ? std::move(yes) : std::move(no)});
    };
    const bool opens = p.exposure.time0 != p.exposure.time1 || p.exposure.s0 != p.exposure.s1;
    say("pixel filter", f.pixel_filter, "samples spread by filter importance sampling",
        "filter is point: every ray goes through its pixel's centre");
    say("lens", f.lens, fmt::format("aperture radius {:.4g}", p.camera.lens.radius), "aperture radius is 0: a pinhole");
    say("time", f.time,
        fmt::format("{} moving bodies, camera {}", count_moving(p), f.moving_camera ? "moves" : "stands still"),
        opens ? "nothing moves while the shutter is open" : "the shutter is instantaneous");
    say("moving camera", f.moving_camera, "the view is computed per ray", "the view is one constant");
    say("planes outside the BVH", f.planes, "infinite planes are tested before the BVH", "no infinite planes");
    say("textures", f.textures, fmt::format("{} textured bodies", p.mappings.size()), "no body wears a texture");
    say("lights", f.lights, fmt::format("{} lights", p.lights.count()), "no lights: ambient light only");
    say("light sample dimensions", f.light_samples, "some lights have an area", "no light has an area");
    say("light tree", f.light_tree, fmt::format("{} of the lights with falloff are drawn at each hit", tree_draws),
        "few lights have a falloff: each is asked");
    say("visible lights", f.visible_lights, fmt::format("{} lights are bodies", p.emitters.size()),
        "no light is a visible body");
    say("highlights", f.specular, "some material is specular", "no material is specular");
    say("scatter", f.scatter, fmt::format("up to {} bounces", scene.render.max_depth),
        scene.render.max_depth == 0 ? "max_depth is 0" : "nothing reflects or refracts");
    say("media stack", f.refraction, "some material refracts", "nothing refracts");
    say("nested media", f.nested_media,
        fmt::format("{} bodies refract: where they overlap, one of them owns the place", count_refracting(p)),
        f.refraction ? "only one body refracts" : "nothing refracts");
    say("media of the eye", f.eye_media,
        fmt::format("found for every camera sample among {} bodies", p.eye_media.size()),
        f.refraction ? "the lens is outside of every body that refracts" : "nothing refracts");
    say("glossy lobes", f.glossy, "some lobe has a spread", "every lobe is sharp");
    say("lights in glossy reflections", f.lobe_lights, "light samples and lobe rays share visible lights",
        "no glossy reflection of a visible light");
    say("brightening", f.brightens, "some material reflects or refracts more than it receives: paths are kept finite",
        "no material sends on more light than it receives");
    say("background", shows_background(scene), "part of the picture: alpha is 1",
        scene.render.transparent_background ? "transparent_background: colour and alpha are 0"
                                            : "background is black: alpha is 0");
    say("double precision", f.double_precision, double_reason.empty() ? "asked for" : double_reason,
        "float is exact enough for every body and pixel");
    return out;
}

}  // namespace drt
