// Bodies and their physics.
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "drt/formats/legacy_map.h"
#include "drt/scene/fields.h"

namespace drt {
namespace {

Vec3d unit(const Vec3d& v) {  // divides, so that axis-aligned directions stay exact
    const double l = length(v);
    return {v.x / l, v.y / l, v.z / l};
}

/// The rotation that takes x, y, z to three orthonormal right-handed axes (Shepperd's method).
Quatd quat_from_axes(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
    const double trace = x.x + y.y + z.z;
    if (trace > 0) {
        const double s = 2 * std::sqrt(1 + trace);  // 4w
        return {s / 4, (y.z - z.y) / s, (z.x - x.z) / s, (x.y - y.x) / s};
    }
    if (x.x > y.y && x.x > z.z) {
        const double s = 2 * std::sqrt(1 + x.x - y.y - z.z);  // 4x
        return {(y.z - z.y) / s, s / 4, (y.x + x.y) / s, (z.x + x.z) / s};
    }
    if (y.y > z.z) {
        const double s = 2 * std::sqrt(1 + y.y - x.x - z.z);  // 4y
        return {(z.x - x.z) / s, (y.x + x.y) / s, s / 4, (z.y + y.z) / s};
    }
    const double s = 2 * std::sqrt(1 + z.z - x.x - y.y);  // 4z
    return {(x.y - y.x) / s, (z.x + x.z) / s, (z.y + y.z) / s, s / 4};
}

struct BodyMapping {
    LegacyMapping& m;
    const LegacyElement& e;
    std::string path;
    void mark(const char* field, std::string_view attribute) { m.mark(path + '.' + field, e, attribute); }
};

Shape map_box(BodyMapping& b) {
    for (const char* attribute : {"vertex0", "vertex1", "vertex2", "height"})
        if (b.e.value(attribute).unread) return Box{};
    const auto box =
        box_from_base(b.e.vector("vertex0"), b.e.vector("vertex1"), b.e.vector("vertex2"), b.e.real("height"));
    if (!box)
        b.m.report.error(b.e.place, "the base of the box has no area, or is too large", b.e.name,
                         "vertex0, vertex1 and vertex2 that are not on one line");
    return box.value_or(Box{});
}

Shape map_shape(BodyMapping& b) {
    const LegacyElement& e = b.e;
    switch (e.type->kind) {
        case LegacyKind::plane:
            b.mark("position", "position");
            b.mark("normal", "normal");
            return Plane{e.vector("position"), e.vector("normal")};
        case LegacyKind::sphere:
            b.mark("center", "position");
            b.mark("radius", "radius");
            b.mark("pole", "v_e");
            b.mark("meridian", "v_n");
            return Sphere{e.vector("position"), e.real("radius"), e.vector("v_e"), e.vector("v_n")};
        case LegacyKind::box:
            return map_box(b);
        default:
            break;
    }
    for (const char* same : {"vertex0", "vertex1", "vertex2"}) b.mark(same, same);
    if (e.type->kind == LegacyKind::triangle)
        return Triangle{e.vector("vertex0"), e.vector("vertex1"), e.vector("vertex2")};
    return Rectangle{e.vector("vertex0"), e.vector("vertex1"), e.vector("vertex2")};
}

std::optional<PhysicsDesc> map_physics(BodyMapping& b) {
    const LegacyElement& e = b.e;
    const bool is_sphere = e.type->kind == LegacyKind::sphere;
    const std::vector<LegacyElement>* events =
        is_sphere ? std::get_if<std::vector<LegacyElement>>(&e.value("add_force_event").data) : nullptr;
    const bool moves = (is_sphere || e.type->kind == LegacyKind::box) && e.real("use_physics") == 1;
    if (!moves) {
        if (events)
            b.m.report.warning(events->front().place, "add_force_event without effect: the sphere has no use_physics 1",
                               e.name);
        return {};
    }
    b.mark("physics", "use_physics");
    PhysicsDesc physics;
    physics.kind = is_sphere ? PhysicsDesc::Kind::dynamic : PhysicsDesc::Kind::fixed;
    if (!is_sphere) return physics;
    physics.density = b.m.options.density;
    if (!events) return physics;
    for (const LegacyElement& event : *events) {
        const std::string path = b.path + ".physics.impulses[" + std::to_string(physics.impulses.size()) + ']';
        b.m.mark(path, event.place);
        b.m.mark(path + ".impulse", event, "force");
        physics.impulses.push_back({event.real("time"), event.vector("force") * b.m.options.legacy_step, {}});
    }
    return physics;
}

bool is_body(LegacyKind kind) {
    return kind == LegacyKind::plane || kind == LegacyKind::sphere || kind == LegacyKind::triangle ||
           kind == LegacyKind::rectangle || kind == LegacyKind::box;
}

/// The material of bodies that name none, added to the scene when first asked for.
class DefaultMaterial {
public:
    explicit DefaultMaterial(LegacyMapping& m) : m_(m) {}
    const std::string& name() {
        if (name_.empty()) {
            Material material;
            material.name = name_ = m_.names.free_name(LegacyKind::material_phong, "default");
            m_.scene.materials.push_back(std::move(material));
        }
        return name_;
    }

private:
    LegacyMapping& m_;
    std::string name_;
};

void map_body(LegacyMapping& m, size_t index, DefaultMaterial& default_material) {
    const LegacyElement& e = m.elements[index];
    BodyMapping b{m, e, "bodies[" + std::to_string(m.scene.bodies.size()) + ']'};
    m.mark(b.path, e.place);
    m.mark(b.path + ".name", e.name_place);
    b.mark("material", "material");
    const auto material = m.names.resolve(index, "material", m.report);
    Body body;
    body.name = m.names.name(index);
    body.shape = map_shape(b);
    body.material = material ? m.names.name(*material) : default_material.name();
    body.physics = map_physics(b);
    if (body.name != e.name) m.report.note(e.name_place, "renamed to " + body.name + ": another body has this name");
    m.scene.bodies.push_back(std::move(body));
}

void note_physics(LegacyMapping& m) {
    bool dynamic = false, impulses = false, fixed = false;
    for (const Body& body : m.scene.bodies) {
        if (!body.physics) continue;
        dynamic |= body.physics->kind == PhysicsDesc::Kind::dynamic;
        fixed |= body.physics->kind == PhysicsDesc::Kind::fixed;
        impulses |= !body.physics->impulses.empty();
    }
    const LegacyOptions& o = m.options;
    if (fixed) m.report.note({}, "assumed: boxes with use_physics stay where they are");
    if (!dynamic) return;
    m.report.note({}, fmt::format("assumed: gravity {} {} {} (--gravity)", o.gravity.x, o.gravity.y, o.gravity.z));
    m.report.note({}, fmt::format("assumed: density {} (--density)", o.density));
    const PhysicsDesc surface;
    m.report.note(
        {}, fmt::format("assumed: restitution {}, friction {}, of every body", surface.restitution, surface.friction));
    if (impulses)
        m.report.note({},
                      fmt::format("assumed: impulse = force * {} s, one legacy step (--legacy-step)", o.legacy_step));
}

}  // namespace

std::optional<Box> box_from_base(const Vec3d& vertex0, const Vec3d& vertex1, const Vec3d& vertex2, double height) {
    const Vec3d edge = vertex1 - vertex0;
    const Vec3d x = unit(edge);
    const Vec3d to_opposite = vertex2 - vertex0;
    const Vec3d other = to_opposite - x * dot(to_opposite, x);
    const double width = length(edge), depth = length(other);
    // Rounding leaves some 1e-16 of `to_opposite` when vertex2 is on the edge's line.
    if (!(depth > 1e-12 * length(to_opposite)) || !(width > 0)) return {};
    const Vec3d z = unit(other);
    const Vec3d y = cross(z, x);  // the direction of (vertex2 - vertex0) x (vertex1 - vertex0)
    const Box box{vertex0 + edge * 0.5 + other * 0.5 + y * (height / 2),
                  {width, std::fabs(height), depth},
                  quat_from_axes(x, y, z)};
    for (int axis = 0; axis < 3; ++axis)
        for (const Vec3d& v : {box.center, box.size})
            if (!(std::fabs(component(v, axis)) <= largest_number)) return {};
    return box;
}

void map_legacy_bodies(LegacyMapping& m) {
    DefaultMaterial default_material(m);
    for (size_t i = 0; i < m.elements.size(); ++i)
        if (is_body(m.elements[i].type->kind)) map_body(m, i, default_material);
    note_physics(m);
}

}  // namespace drt
