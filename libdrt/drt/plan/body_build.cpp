#include "drt/plan/body_build.h"

#include <cmath>

namespace drt {

namespace {

// Tangent directions of a plane with unit normal n (docs/scene-format.md, texture mapping).
struct Tangents {
    Vec3d t, b;
};

Tangents plane_tangents(const Vec3d& n) {
    const Vec3d h = std::abs(n.y) > 0.9 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
    const Vec3d t = normalize(cross(h, n));
    return {t, cross(n, t)};
}

FlatShape<double> flat(const Vec3d& origin, const Vec3d& e0, const Vec3d& e1, Outline outline) {
    const Vec3d n = cross(e0, e1);
    const double n2 = dot(n, n);
    // dual basis: dot(da, e0) = 1, dot(da, e1) = 0, and the other way round
    return {origin, normalize(n), cross(e1, n) / n2, cross(n, e0) / n2, outline};
}

BuiltBody build(const Plane& p) {
    const Vec3d n = normalize(p.normal);
    const Tangents d = plane_tangents(n);
    return {PlaneShape<double>{n}, p.position, Mapping<double>{MappingKind::planar, d.t, -d.b, {}, {}}};
}

BuiltBody build(const Sphere& s) {
    const Vec3d pole = normalize(s.pole);
    const Vec3d meridian = normalize(s.meridian - pole * dot(s.meridian, pole));
    return {SphereShape<double>{s.radius}, s.center,
            Mapping<double>{MappingKind::spherical, meridian, cross(pole, meridian), pole, {}}};
}

BuiltBody build(const Triangle& t) {
    const Vec3d center = (t.vertex0 + t.vertex1 + t.vertex2) / 3.0;
    return {flat(t.vertex0 - center, t.vertex1 - t.vertex0, t.vertex2 - t.vertex0, Outline::triangle), center, {}};
}

BuiltBody build(const Parallelogram& p) {
    const Vec3d half = (p.edge0 + p.edge1) * 0.5;
    // Coordinates along skewed edges: the dual basis times the edge lengths measures scene units along each edge.
    const FlatShape<double> shape = flat(-half, p.edge0, p.edge1, Outline::parallelogram);
    Mapping<double> m{MappingKind::planar, shape.da * length(p.edge0), shape.db * length(p.edge1), {}, -half};
    return {shape, p.corner + half, m};
}

BuiltBody build(const Rectangle& r) {
    const Vec3d e0 = r.vertex1 - r.vertex0;
    const Vec3d to2 = r.vertex2 - r.vertex0;
    const Vec3d e1 = to2 - e0 * (dot(to2, e0) / dot(e0, e0));
    return build(Parallelogram{r.vertex0, e0, e1});
}

BuiltBody build(const Box& b) {
    const Quatd q = normalize(b.orientation);
    const Vec3d x = rotate(q, Vec3d{1, 0, 0}), y = rotate(q, Vec3d{0, 1, 0}), z = rotate(q, Vec3d{0, 0, 1});
    return {BoxShape<double>{x, y, z, b.size * 0.5}, b.center,
            Mapping<double>{MappingKind::box, x, y, z, b.size * 0.5}};
}

BuiltBody build(const Cylinder& c) {
    const Vec3d axis = c.to - c.from;
    const Vec3d a = normalize(axis);
    const Vec3d x = plane_tangents(a).t, y = cross(a, x);
    const double half = length(axis) * 0.5;
    return {CylinderShape<double>{x, y, a, c.radius, half, c.capped}, (c.from + c.to) * 0.5,
            Mapping<double>{MappingKind::cylindrical, x, y, a, {c.radius, half, 0}}};
}

BuiltBody build(const Disc& d) {
    const Tangents t = plane_tangents(normalize(d.normal));
    FlatShape<double> shape = flat({}, t.t * d.radius, t.b * d.radius, Outline::disc);
    shape.normal = normalize(d.normal);
    return {shape, d.center, {}};
}

}  // namespace

BuiltBody build_body(const Shape& shape) {
    return std::visit(
        [](const auto& s) -> BuiltBody {
            if constexpr (std::is_same_v<std::decay_t<decltype(s)>, SphereSet>)
                throw Error(ErrorKind::internal, "a sphere set is many bodies");
            else
                return build(s);
        },
        shape);
}

BuiltBody turned(BuiltBody b, const Quatd& q) {
    const auto turn = [&](Vec3d& v) { v = rotate(q, v); };
    std::visit(
        [&](auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, FlatShape<double>>) {
                turn(s.origin), turn(s.normal), turn(s.da), turn(s.db);
            } else if constexpr (std::is_same_v<S, PlaneShape<double>>) {
                turn(s.normal);
            } else if constexpr (!std::is_same_v<S, SphereShape<double>>) {
                turn(s.ax), turn(s.ay), turn(s.az);
            }
        },
        b.shape);
    if (b.mapping) {
        turn(b.mapping->ax), turn(b.mapping->ay), turn(b.mapping->az);
        if (b.mapping->kind == MappingKind::planar) turn(b.mapping->origin);
    }
    return b;
}

BuiltBody build_light_body(const LightShape& light) {
    if (const auto* r = std::get_if<RectLight>(&light)) return build(Parallelogram{r->corner, r->edge_x, r->edge_y});
    const SphereLight& s = std::get<SphereLight>(light);
    return build(Sphere{s.center, s.radius});
}

}  // namespace drt
