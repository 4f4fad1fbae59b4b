#include "drt/dynamics/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace drt {

namespace {

// Nearest points to a point `p`, in the body's own axes: the point of the body, and out of it the normal and the
// (signed) distance.
struct Foot {
    double distance;
    Vec3d normal, point;
};

Foot from_outside(const Vec3d& p, const Vec3d& foot, const Vec3d& normal_if_on_it) {
    const double d = length(p - foot);
    return {d, d > 0 ? (p - foot) / d : normal_if_on_it, foot};
}

Foot foot(const Vec3d& p, const SphereCollider& c) {
    const double d = length(p);
    const Vec3d n = d > 0 ? p / d : Vec3d{0, 1, 0};
    return {d - c.radius, n, n * c.radius};
}

Foot foot(const Vec3d& p, const BoxCollider& c) {
    const Vec3d h = c.half, q{std::clamp(p.x, -h.x, h.x), std::clamp(p.y, -h.y, h.y), std::clamp(p.z, -h.z, h.z)};
    if (p != q) return from_outside(p, q, {});
    // From inside, through the nearest face.
    const double depth[3] = {h.x - std::abs(p.x), h.y - std::abs(p.y), h.z - std::abs(p.z)};
    const auto axis = std::min_element(depth, depth + 3) - depth;
    const Vec3d n{axis == 0 ? std::copysign(1.0, p.x) : 0, axis == 1 ? std::copysign(1.0, p.y) : 0,
                  axis == 2 ? std::copysign(1.0, p.z) : 0};
    return {-depth[axis], n, p + n * depth[axis]};
}

Foot foot(const Vec3d& p, const CylinderCollider& c) {
    const double rho = std::hypot(p.x, p.y), k = rho > c.radius ? c.radius / rho : 1;
    const Vec3d q{p.x * k, p.y * k, std::clamp(p.z, -c.half_height, c.half_height)};
    if (p != q) return from_outside(p, q, {});
    const double side = c.radius - rho, cap = c.half_height - std::abs(p.z);
    const Vec3d out =
        cap < side ? Vec3d{0, 0, std::copysign(1.0, p.z)} : (rho > 0 ? Vec3d{p.x / rho, p.y / rho, 0} : Vec3d{1, 0, 0});
    const double depth = std::min(side, cap);
    return {-depth, out, p + out * depth};
}

Foot foot(const Vec3d& p, const PolygonCollider& c) {
    const std::vector<Vec3d>& v = c.vertices;
    const Vec3d n = normalize(cross(v[1] - v[0], v[2] - v[0]));
    bool inside = true;
    Vec3d best;
    double best_squared = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < v.size(); ++i) {
        const Vec3d a = v[i], edge = v[(i + 1) % v.size()] - a;
        inside = inside && dot(cross(edge, p - a), n) >= 0;
        const Vec3d q = a + edge * std::clamp(dot(p - a, edge) / length_squared(edge), 0.0, 1.0);
        if (const double d = length_squared(p - q); d < best_squared) best_squared = d, best = q;
    }
    if (inside) best = p - n * dot(p - v[0], n);
    return from_outside(p, best, n);
}

Foot foot(const Vec3d& p, const DiscCollider& c) {
    const Vec3d n = normalize(c.normal), flat = p - n * dot(p, n);
    const double rho = length(flat);
    return from_outside(p, rho > c.radius ? flat * (c.radius / rho) : flat, n);
}

Foot foot(const Vec3d& p, const PlaneCollider& c) {
    const Vec3d n = normalize(c.normal);
    return {dot(p, n), n, p - n * dot(p, n)};
}

Nearest sphere_to(const SphereCollider& c, const RigidState& s, const Collider& other, const RigidState& at) {
    const Vec3d p = rotate_back(at.orientation, s.position - at.position);
    const Foot f = std::visit([&](const auto& o) { return foot(p, o); }, other);
    return {f.distance - c.radius, rotate(at.orientation, f.normal), at.position + rotate(at.orientation, f.point),
            touch_distance};
}

// The point of a convex body that is farthest along a direction of its own axes.
Vec3d support(const SphereCollider& c, const Vec3d& d) { return d * c.radius; }
Vec3d support(const BoxCollider& c, const Vec3d& d) {
    return {std::copysign(c.half.x, d.x), std::copysign(c.half.y, d.y), std::copysign(c.half.z, d.z)};
}
Vec3d support(const CylinderCollider& c, const Vec3d& d) {
    const double across = std::hypot(d.x, d.y), k = across > 0 ? c.radius / across : 0;
    return {d.x * k, d.y * k, std::copysign(c.half_height, d.z)};
}
Vec3d support(const PlaneCollider&, const Vec3d&) { return {}; }
Vec3d support(const PolygonCollider& c, const Vec3d& d) {
    return *std::max_element(c.vertices.begin(), c.vertices.end(),
                             [&](const Vec3d& a, const Vec3d& b) { return dot(a, d) < dot(b, d); });
}
Vec3d support(const DiscCollider& c, const Vec3d& d) {
    const Vec3d n = normalize(c.normal), flat = d - n * dot(d, n);
    const double rho = length(flat);
    return rho > 0 ? flat * (c.radius / rho) : Vec3d{};
}

Nearest to_plane(const Collider& c, const RigidState& s, const PlaneCollider& plane, const RigidState& at) {
    const Vec3d n = rotate(at.orientation, normalize(plane.normal)), d = rotate_back(s.orientation, -n);
    const Vec3d deepest =
        s.position + rotate(s.orientation, std::visit([&](const auto& o) { return support(o, d); }, c));
    const double distance = dot(deepest - at.position, n);
    return {distance, n, deepest - n * distance};
}

Nearest turned_round(const Nearest& n) { return {n.distance, -n.normal, n.point + n.normal * n.distance, n.error}; }

}  // namespace

std::optional<Nearest> nearest_in_closed_form(const Collider& a, const RigidState& sa, const Collider& b,
                                              const RigidState& sb) {
    if (const auto* sphere = std::get_if<SphereCollider>(&a)) return sphere_to(*sphere, sa, b, sb);
    if (const auto* sphere = std::get_if<SphereCollider>(&b)) return turned_round(sphere_to(*sphere, sb, a, sa));
    if (const auto* plane = std::get_if<PlaneCollider>(&b)) return to_plane(a, sa, *plane, sb);
    if (const auto* plane = std::get_if<PlaneCollider>(&a)) return turned_round(to_plane(b, sb, *plane, sa));
    return std::nullopt;
}

double bounding_radius(const Collider& c) {
    struct Radius {
        double operator()(const SphereCollider& s) const { return s.radius; }
        double operator()(const BoxCollider& b) const { return length(b.half); }
        double operator()(const CylinderCollider& b) const { return std::hypot(b.radius, b.half_height); }
        double operator()(const PlaneCollider&) const { return std::numeric_limits<double>::infinity(); }
        double operator()(const PolygonCollider& p) const {
            double r = 0;
            for (const Vec3d& v : p.vertices) r = std::max(r, length(v));
            return r;
        }
        double operator()(const DiscCollider& d) const { return d.radius; }
    };
    return std::visit(Radius{}, c);
}

double corner_reach(const Collider& c) {
    const bool round = std::holds_alternative<SphereCollider>(c) || std::holds_alternative<PlaneCollider>(c);
    return round ? 0 : bounding_radius(c);
}

}  // namespace drt
