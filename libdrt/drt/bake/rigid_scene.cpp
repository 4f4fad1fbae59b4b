#include "drt/bake/rigid_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/bake/course.h"
#include "drt/base/constants.h"
#include "drt/scene/mass.h"

namespace drt {

namespace {

// In scene units, about the body's centre.
struct Solid {
    Collider collider;
    Vec3d center;
    Quatd frame;
};

// A turn that takes z to `axis`.
Quatd frame_along(const Vec3d& axis) {
    const Vec3d a = normalize(axis);
    if (a.z < 0) return frame_along(-axis) * Quatd{0, 1, 0, 0};  // z to -z first
    return normalize(Quatd{1 + a.z, -a.y, a.x, 0});
}

Solid polygon(std::vector<Vec3d> vertices, const Vec3d& center) {
    for (Vec3d& v : vertices) v -= center;
    return {PolygonCollider{std::move(vertices)}, center, {}};
}

Solid solid(const Plane& p) { return {PlaneCollider{normalize(p.normal)}, p.position, {}}; }
Solid solid(const Sphere& s) { return {SphereCollider{s.radius}, s.center, {}}; }
Solid solid(const Box& b) { return {BoxCollider{b.size * 0.5}, b.center, normalize(b.orientation)}; }
Solid solid(const Cylinder& c) {
    const Vec3d axis = c.to - c.from;
    return {CylinderCollider{c.radius, length(axis) * 0.5}, (c.from + c.to) * 0.5, frame_along(axis)};
}
Solid solid(const Disc& d) { return {DiscCollider{normalize(d.normal), d.radius}, d.center, {}}; }
Solid solid(const Triangle& t) {
    return polygon({t.vertex0, t.vertex1, t.vertex2}, (t.vertex0 + t.vertex1 + t.vertex2) / 3.0);
}
Solid solid(const Parallelogram& p) {
    return polygon({p.corner, p.corner + p.edge0, p.corner + p.edge0 + p.edge1, p.corner + p.edge1},
                   p.corner + (p.edge0 + p.edge1) * 0.5);
}
Solid solid(const Rectangle& r) {
    const Vec3d edge = r.vertex1 - r.vertex0, to2 = r.vertex2 - r.vertex0;
    return solid(Parallelogram{r.vertex0, edge, to2 - edge * (dot(to2, edge) / dot(edge, edge))});
}
Solid solid(const SphereSet&) { throw Error(ErrorKind::internal, "a sphere set cannot take part in a simulation"); }

Solid solid_of(const Shape& shape) {
    return std::visit([](const auto& s) { return solid(s); }, shape);
}

double size_of(const Collider& collider) {
    if (const auto* s = std::get_if<SphereCollider>(&collider)) return s->radius;
    if (const auto* b = std::get_if<BoxCollider>(&collider)) return std::min({b->half.x, b->half.y, b->half.z});
    const auto& c = std::get<CylinderCollider>(collider);
    return std::min(c.radius, c.half_height);
}

bool is_dynamic(const Body& b) { return b.physics->kind == PhysicsDesc::Kind::dynamic; }

RigidUnits units_of(const SceneDesc& scene) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    RigidUnits u{inf, inf, {}};
    Vec3d low{inf, inf, inf}, high{-inf, -inf, -inf};
    for (const Body& b : scene.bodies) {
        if (!is_dynamic(b)) continue;
        const Solid s = solid_of(b.shape);
        u.length = std::min(u.length, size_of(s.collider));
        u.mass = std::min(u.mass, mass_properties(b.shape, *b.physics)->mass);
        low = {std::min(low.x, s.center.x), std::min(low.y, s.center.y), std::min(low.z, s.center.z)};
        high = {std::max(high.x, s.center.x), std::max(high.y, s.center.y), std::max(high.z, s.center.z)};
    }
    if (u.length == inf) return {};  // nothing moves freely
    u.origin = low + (high - low) * 0.5;
    return u;
}

void scale(Collider& collider, double by) {
    struct Scale {
        double by;
        void operator()(SphereCollider& c) const { c.radius *= by; }
        void operator()(BoxCollider& c) const { c.half *= by; }
        void operator()(CylinderCollider& c) const { c.radius *= by, c.half_height *= by; }
        void operator()(PlaneCollider&) const {}
        void operator()(PolygonCollider& c) const {
            for (Vec3d& v : c.vertices) v *= by;
        }
        void operator()(DiscCollider& c) const { c.radius *= by; }
    };
    std::visit(Scale{by}, collider);
}

Vec3d in_radians(const Vec3d& degrees) { return degrees * (pi<double> / 180); }

void add_dynamics(RigidBody& body, const Body& b, const RigidUnits& u) {
    const PhysicsDesc& p = *b.physics;
    const MassProperties m = *mass_properties(b.shape, p);
    body.kind = RigidBody::Kind::dynamic;
    body.mass = m.mass / u.mass;
    body.inertia = m.inertia / (u.mass * u.length * u.length);
    body.start.velocity = p.velocity / u.length;
    body.start.spin = in_radians(p.angular_velocity_degrees);
    for (const ImpulseEvent& e : p.impulses)
        body.blows.push_back({e.time, e.impulse / (u.mass * u.length), e.at.value_or(Vec3d{}) / u.length});
    std::stable_sort(body.blows.begin(), body.blows.end(),
                     [](const Blow& l, const Blow& r) { return l.time < r.time; });
    for (const ForceEvent& e : p.forces) body.pushes.push_back({e.from, e.until, e.force / (u.mass * u.length)});
}

// Events outside the simulated time have no effect.
void drop_events_outside(RigidBody& body, double begin, double end) {
    std::erase_if(body.blows, [&](const Blow& b) { return b.time < begin || b.time >= end; });
    std::erase_if(body.pushes, [&](const Push& p) { return p.until <= begin || p.from >= end; });
    for (Push& p : body.pushes) p.from = std::max(p.from, begin);
}

}  // namespace

RigidModel build_rigid_scene(const BakeInput& in) {
    RigidModel model;
    model.units = units_of(in.scene);
    const RigidUnits& u = model.units;
    model.scene.gravity = gravity_of(in.scene) / u.length;
    for (const Body& b : in.scene.bodies) {
        Solid s = solid_of(b.shape);
        scale(s.collider, 1 / u.length);
        RigidBody body;
        body.collider = std::move(s.collider);
        body.friction = b.physics->friction;
        body.rolling_friction = b.physics->rolling_friction;
        body.restitution = b.physics->restitution;
        body.start.position = u.from_scene(s.center);
        body.start.orientation = s.frame;
        if (is_dynamic(b)) add_dynamics(body, b, u);
        drop_events_outside(body, in.begin, in.end);
        if (b.physics->kind == PhysicsDesc::Kind::kinematic && b.motion) {
            body.kind = RigidBody::Kind::kinematic;
            body.course = course_of(*b.motion, u, s.frame, in.begin, in.end);
            body.start = body.course.front().from;
        }
        model.scene.bodies.push_back(std::move(body));
        model.frames.push_back(s.frame);
    }
    return model;
}

Vec3d center_of(const Shape& shape) { return solid_of(shape).center; }

}  // namespace drt
