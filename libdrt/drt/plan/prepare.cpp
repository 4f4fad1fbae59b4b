#include "drt/plan/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "drt/formats/formats.h"
#include "drt/light/light_choice.h"
#include "drt/plan/eye_media.h"
#include "drt/plan/motion_build.h"
#include "drt/plan/rank.h"

namespace drt {

namespace {

using MaterialIndex = std::unordered_map<std::string, int>;

MaterialIndex index_materials(const SceneDesc& scene) {
    MaterialIndex index;
    for (size_t i = 0; i < scene.materials.size(); ++i) index.emplace(scene.materials[i].name, int(i));
    return index;
}

void add_body(PreparedScene& p, const BuiltBody& built, std::vector<MotionPiece<double>> path, int source, int material,
              int emitter, bool textured) {
    p.bodies.push_back({built.shape, built.center, std::move(path)});
    p.body_source.push_back(source);
    p.body_material.push_back(material);
    p.body_emitter.push_back(emitter);
    p.body_mapping.push_back(textured && built.mapping ? int(p.mappings.size()) : -1);
    if (textured && built.mapping) p.mappings.push_back(*built.mapping);
}

void add_sphere_set(PreparedScene& p, const SphereSet& set, int source, int material) {
    for (const SphereRecord& s : read_sphere_set(set.file))
        add_body(p, {SphereShape<double>{s.radius}, s.center, {}}, {}, source, material, -1, false);
}

void add_described_body(PreparedScene& p, const SceneDesc& scene, int source, int material) {
    const Body& body = scene.bodies[size_t(source)];
    BuiltBody built = build_body(body.shape);
    std::vector<MotionPiece<double>> path;
    if (body.motion) {
        path = build_path(*body.motion, p.exposure.time0, p.exposure.time1);
        if (is_constant(path)) {
            built = turned(built, path[0].q0);
            built.center = path[0].c0;
            path.clear();
        }
    }
    add_body(p, built, std::move(path), source, material, -1, !scene.materials[size_t(material)].texture.empty());
}

LightCommon<float> add_light_body(PreparedScene& p, const Light& light) {
    LightCommon<float> common{light.color, light.falloff == Light::Falloff::inverse_square, -1};
    if (!light.visible) return common;
    const auto* rect = std::get_if<RectLight>(&light.shape);
    common.body = int(p.bodies.size());
    p.emitters.push_back({light.color, !rect || rect->two_sided});
    add_body(p, build_light_body(light.shape), {}, -1, -1, int(p.emitters.size()) - 1, false);
    return common;
}

// A black light may be seen, but nothing asks it.
void add_light(PreparedScene& p, const Light& light) {
    const LightCommon<float> common = add_light_body(p, light);
    const auto add = [&](LightKind kind, auto& lights, const auto& l) {
        if (strength(l) <= 0) return;
        if (light.visible) p.emitters.back().light = light_id::pack(kind, lights.size());
        lights.push_back(l);
    };
    if (const auto* l = std::get_if<PointLight>(&light.shape)) {
        add(LightKind::point, p.lights.points, PointLightData<double>{common, l->position});
    } else if (const auto* r = std::get_if<RectLight>(&light.shape)) {
        add(LightKind::rect, p.lights.rects, make_rect_light(common, r->corner, r->edge_x, r->edge_y, r->two_sided));
    } else if (const auto* s = std::get_if<SphereLight>(&light.shape)) {
        const bool radial = s->distribution == SphereLight::Distribution::radial;
        add(LightKind::sphere, p.lights.spheres, SphereLightData<double>{common, s->center, s->radius, radial});
    }
}

// Coordinates near the eye keep their digits in float, wherever the scene lies.
void recenter(PreparedScene& p) {
    p.origin = view_at(p.camera, 0.0).eye;
    const auto move = [&](Vec3d& v) { v = v - p.origin; };
    for (BodyInput& b : p.bodies) {
        move(b.center);
        for (MotionPiece<double>& piece : b.path) move(piece.c0);
    }
    for (auto& l : p.lights.points) move(l.position);
    for (auto& l : p.lights.rects) move(l.corner), move(l.center);
    for (auto& l : p.lights.spheres) move(l.center);
    // A plane is the same wherever on it its centre lies; the nearest place has the smallest rounding. (Textures start
    // from the centre.)
    for (size_t i = 0; i < p.bodies.size(); ++i)
        if (const auto* plane = std::get_if<PlaneShape<double>>(&p.bodies[i].shape))
            if (p.bodies[i].path.empty() && p.body_mapping[i] < 0)
                p.bodies[i].center = plane->normal * dot(p.bodies[i].center, plane->normal);
    move(p.camera.eye[0]);
    for (MotionPiece<double>& piece : p.camera.path) move(piece.c0);
}

}  // namespace

PreparedScene prepare(const SceneDesc& scene, const PlanOptions& options) {
    PreparedScene p;
    p.exposure = exposure_of_frame(scene, options.frame, options.camera);
    const MaterialIndex materials = index_materials(scene);
    for (int i = 0; i < int(scene.bodies.size()); ++i) {
        const Body& b = scene.bodies[size_t(i)];
        const int material = materials.at(b.material);
        if (const auto* set = std::get_if<SphereSet>(&b.shape))
            add_sphere_set(p, *set, i, material);
        else
            add_described_body(p, scene, i, material);
    }
    for (const Light& l : scene.lights) add_light(p, l);
    p.camera = build_camera(scene.render, scene.cameras[size_t(p.exposure.camera)], p.exposure);
    recenter(p);
    plan_light_choice(p.lights);
    assign_roles(p, scene);
    check_nesting(p, scene);
    p.eye_media = find_eye_media(p);
    return p;
}

namespace {

// The smallest and the largest length that shape the surface.
struct Scale {
    double smallest = 0, largest = 0;
};

Scale scale_of(const SphereShape<double>& s) { return {s.radius, s.radius}; }
Scale scale_of(const FlatShape<double>& s) {
    const double a = 1 / length(s.da), b = 1 / length(s.db);
    return {std::min(a, b), std::max(a, b)};
}
Scale scale_of(const BoxShape<double>& s) {
    return {std::min({s.half.x, s.half.y, s.half.z}), std::max({s.half.x, s.half.y, s.half.z})};
}
Scale scale_of(const CylinderShape<double>& s) {
    return {std::min(s.radius, s.half_height), std::max(s.radius, s.half_height)};
}
Scale scale_of(const PlaneShape<double>&) { return {1, 1}; }

// Calls f with where the body's centre is; for a moving body, where the pieces of its path begin and end.
template <class F>
void visit_centers(const BodyInput& b, F f) {
    if (b.path.empty()) return f(b.center);
    for (const MotionPiece<double>& p : b.path) f(p.c0), f(p.c0 + p.c1 + p.c2 + p.c3);
}

bool is_plane(const BodyInput& b) { return std::holds_alternative<PlaneShape<double>>(b.shape); }

}  // namespace

std::string needs_double(const PreparedScene& p) {
    constexpr double limit = 1e4;            // relative error of a hit point on its shape: limit * 2^-24 = 6e-4
    constexpr double smallest_pixel = 2e-5;  // radians: 300 float steps of a unit direction
    double reach = 0;                        // the longest coordinate that a ray can have, planes aside
    for (const BodyInput& b : p.bodies) {
        if (is_plane(b)) continue;
        const double size = std::visit([](const auto& s) { return scale_of(s).largest; }, b.shape);
        visit_centers(b, [&](const Vec3d& center) { reach = std::max(reach, length(center) + size); });
    }
    for (const BodyInput& b : p.bodies) {
        if (is_plane(b)) continue;
        const Scale s = std::visit([](const auto& shape) { return scale_of(shape); }, b.shape);
        if (reach > limit * s.smallest)
            return fmt::format("a body of size {:.3g} in a scene of size {:.3g}", s.smallest, reach);
        // Seen from close up, a sphere's surface must be exact against the eye's distance to it, not its radius.
        if (const auto* sphere = std::get_if<SphereShape<double>>(&b.shape)) {
            double gap = std::numeric_limits<double>::infinity();
            visit_centers(b, [&](const Vec3d& c) { gap = std::min(gap, std::abs(length(c) - sphere->radius)); });
            if (sphere->radius > limit * gap)
                return fmt::format("a sphere of radius {:.3g} seen from {:.3g}", sphere->radius, gap);
        }
    }
    const double pixel = std::min(view_at(p.camera, 0.0).pixel_size, view_at(p.camera, 1.0).pixel_size);
    if (pixel < smallest_pixel) return fmt::format("pixels of {:.3g} radians", pixel);
    return {};
}

}  // namespace drt
