#include "reference/motion.h"

#include <stdexcept>

#include "drt/base/constants.h"

namespace drt::reference {
namespace {

/// A turn by axis and angle, the form in which a part of a turn is easily told.
struct AxisAngle {
    Vec3d axis{0, 1, 0};
    double angle = 0;
};

AxisAngle axis_angle(const Turn& turn) { return {normalize(turn.axis), radians(turn.degrees)}; }

/// The short turn that leads from one orientation to another.
AxisAngle short_turn(const Quatd& from, const Quatd& to) {
    Quatd q = to * conjugate(from);
    if (q.w < 0) q = -q;
    const Vec3d v{q.x, q.y, q.z};
    const double sine = length(v);
    if (sine < 1e-12) return {};
    return {v / sine, 2 * std::atan2(sine, q.w)};
}

Quatd orientation_at_key(const std::vector<MotionKey>& keys, size_t i) {
    if (!keys[i].turn) return normalize(keys[i].orientation.value_or(Quatd{}));
    const AxisAngle turn = axis_angle(*keys[i].turn);
    return quat_from_axis_angle(turn.axis, turn.angle) * (i == 0 ? Quatd{} : orientation_at_key(keys, i - 1));
}

/// Derivative of the position at a key: the slope between its neighbours (one-sided at the ends).
Vec3d tangent_at_key(const std::vector<MotionKey>& keys, size_t i) {
    const MotionKey& before = keys[i == 0 ? 0 : i - 1];
    const MotionKey& after = keys[i + 1 == keys.size() ? i : i + 1];
    return (after.position - before.position) / (after.time - before.time);
}

Vec3d position_between(const Motion& motion, size_t i, double time) {
    const MotionKey &a = motion.keys[i], &b = motion.keys[i + 1];
    const double length = b.time - a.time, u = (time - a.time) / length;
    if (motion.interpolation == Motion::Interpolation::linear) return a.position * (1 - u) + b.position * u;
    const double h00 = (1 + 2 * u) * (1 - u) * (1 - u), h10 = u * (1 - u) * (1 - u);
    const double h01 = u * u * (3 - 2 * u), h11 = u * u * (u - 1);
    return a.position * h00 + tangent_at_key(motion.keys, i) * (h10 * length) + b.position * h01 +
           tangent_at_key(motion.keys, i + 1) * (h11 * length);
}

Quatd orientation_between(const std::vector<MotionKey>& keys, size_t i, double time) {
    const double u = (time - keys[i].time) / (keys[i + 1].time - keys[i].time);
    const Quatd from = orientation_at_key(keys, i);
    const AxisAngle turn =
        keys[i + 1].turn ? axis_angle(*keys[i + 1].turn) : short_turn(from, orientation_at_key(keys, i + 1));
    return quat_from_axis_angle(turn.axis, turn.angle * u) * from;
}

}  // namespace

Pose pose_at(const Motion& motion, double time) {
    const auto& keys = motion.keys;
    if (keys.empty()) throw std::invalid_argument("motion without keys");
    if (time <= keys.front().time) return {keys.front().position, orientation_at_key(keys, 0)};
    if (time >= keys.back().time) return {keys.back().position, orientation_at_key(keys, keys.size() - 1)};
    size_t i = 0;
    while (time >= keys[i + 1].time) ++i;
    return {position_between(motion, i, time), orientation_between(keys, i, time)};
}

Vec3d second_edge(const Rectangle& r) {
    const Vec3d edge0 = r.vertex1 - r.vertex0, slanted = r.vertex2 - r.vertex0;
    return slanted - edge0 * (dot(slanted, edge0) / dot(edge0, edge0));
}

Vec3d center_of(const Shape& shape) {
    struct Center {
        Vec3d operator()(const Plane& s) const { return s.position; }
        Vec3d operator()(const Sphere& s) const { return s.center; }
        Vec3d operator()(const Triangle& s) const { return (s.vertex0 + s.vertex1 + s.vertex2) / 3.0; }
        Vec3d operator()(const Rectangle& s) const {
            return s.vertex0 + (s.vertex1 - s.vertex0 + second_edge(s)) * 0.5;
        }
        Vec3d operator()(const Parallelogram& s) const { return s.corner + (s.edge0 + s.edge1) * 0.5; }
        Vec3d operator()(const Box& s) const { return s.center; }
        Vec3d operator()(const Cylinder& s) const { return (s.from + s.to) * 0.5; }
        Vec3d operator()(const Disc& s) const { return s.center; }
        Vec3d operator()(const SphereSet&) const { return {}; }
    };
    return std::visit(Center{}, shape);
}

}  // namespace drt::reference
