#include <cmath>
#include <optional>

#include "drt/base/constants.h"
#include "drt/dynamics/clip.h"
#include "drt/dynamics/polytope.h"

namespace drt {

namespace {

constexpr double almost_parallel = 0.02;  // sine of the angle
constexpr int corners_of_rim = 16;

struct Round {
    Vec3d center, axis;  // unit
    double radius = 0, half_height = 0;
};

std::optional<Round> round_of(const Collider& c, const RigidState& s) {
    if (const auto* cylinder = std::get_if<CylinderCollider>(&c))
        return Round{s.position, rotate(s.orientation, Vec3d{0, 0, 1}), cylinder->radius, cylinder->half_height};
    if (const auto* disc = std::get_if<DiscCollider>(&c))
        return Round{s.position, rotate(s.orientation, normalize(disc->normal)), disc->radius, 0};
    return std::nullopt;
}

struct FlatSide {
    Vec3d normal;  // outwards, unit
    std::vector<Vec3d> outline;
};

FlatSide cap(const Round& r, const Vec3d& direction) {
    FlatSide out;
    out.normal = dot(r.axis, direction) > 0 ? r.axis : -r.axis;
    const Vec3d x = normalize(cross(std::abs(r.axis.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, out.normal));
    const Vec3d y = cross(out.normal, x);
    for (int k = 0; k < corners_of_rim; ++k) {
        const double angle = 2 * pi<double> * k / corners_of_rim;
        out.outline.push_back(r.center + out.normal * r.half_height +
                              (x * std::cos(angle) + y * std::sin(angle)) * r.radius);
    }
    return out;
}

// The side of a body that looks in a direction, if it is flat.
std::optional<FlatSide> flat_side(const Collider& c, const RigidState& s, const Vec3d& direction) {
    if (const auto round = round_of(c, s)) {
        if (length(cross(round->axis, direction)) > almost_parallel) return std::nullopt;
        return cap(*round, direction);
    }
    const Polytope p = make_polytope(c, s);
    for (const Polytope::Face& f : p.faces) {
        if (length(f.normal - direction) > almost_parallel) continue;
        FlatSide out{f.normal, {}};
        for (const int k : f.loop) out.outline.push_back(p.vertices[size_t(k)]);
        return out;
    }
    return std::nullopt;
}

// The line along which a cylinder lies on what is below it.
std::vector<Vec3d> lowest_line(const Collider& c, const RigidState& s, const Vec3d& up) {
    const auto round = round_of(c, s);
    if (!round || round->half_height <= 0 || std::abs(dot(round->axis, up)) > almost_parallel) return {};
    const Vec3d down = normalize(round->axis * dot(round->axis, up) - up) * round->radius;
    const Vec3d along = round->axis * round->half_height;
    return {round->center + down - along, round->center + down + along};
}

// Of what is above a flat side, on it and on the side.
std::vector<SurfacePoint> points_above(const FlatSide& side, std::vector<Vec3d> above, double reach) {
    for (size_t i = 0; i < side.outline.size() && !above.empty(); ++i) {
        const Vec3d& corner = side.outline[i];
        const Vec3d edge = side.outline[(i + 1) % side.outline.size()] - corner;
        above = clip(above, corner, cross(edge, side.normal));
    }
    std::vector<SurfacePoint> out;
    for (const Vec3d& p : above) {
        const double gap = dot(p - side.outline[0], side.normal);
        if (gap <= reach) out.push_back({gap, p, p - side.normal * gap});
    }
    return out;
}

}  // namespace

std::vector<SurfacePoint> contact_points_of_round(const Collider& a, const RigidState& sa, const Collider& b,
                                                  const RigidState& sb, const Vec3d& normal, double reach) {
    const auto side_a = flat_side(a, sa, -normal), side_b = flat_side(b, sb, normal);
    if (side_b) {
        const std::vector<Vec3d> above = side_a ? side_a->outline : lowest_line(a, sa, side_b->normal);
        return spread(points_above(*side_b, above, reach));
    }
    if (!side_a) return {};
    std::vector<SurfacePoint> out = points_above(*side_a, lowest_line(b, sb, side_a->normal), reach);
    for (SurfacePoint& p : out) std::swap(p.on_a, p.on_b);
    return spread(std::move(out));
}

}  // namespace drt
