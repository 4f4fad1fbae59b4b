#include "drt/dynamics/path.h"

#include <algorithm>
#include <cmath>

namespace drt {

namespace {

bool is_isotropic(const Vec3d& inertia) { return inertia.x == inertia.y && inertia.y == inertia.z; }

// The turn by a rotation vector (axis times angle).
Quatd turn(const Vec3d& v) {
    const double angle = length(v);
    return angle > 0 ? quat_from_axis_angle(v / angle, angle) : Quatd{};
}

Vec3d angular_momentum(const RigidBody& b, const RigidState& s) {
    const Vec3d w = rotate_back(s.orientation, s.spin);
    return rotate(s.orientation, Vec3d{b.inertia.x * w.x, b.inertia.y * w.y, b.inertia.z * w.z});
}

Vec3d spin_of(const RigidBody& b, const Quatd& q, const Vec3d& momentum) {
    const Vec3d l = rotate_back(q, momentum);
    return rotate(q, Vec3d{l.x / b.inertia.x, l.y / b.inertia.y, l.z / b.inertia.z});
}

// Between contacts the centre flies a parabola and a body whose inertia is the same about all axes turns uniformly:
// both exact. The tumbling of others is integrated to rounding: the angular momentum is constant.

// Fourth order, after Crouch and Grossman's idea of composing turns: the stages' spins are averaged as rotation vectors
// with the commutator that makes it fourth order (Munthe-Kaas 1999).
Quatd tumble(const RigidBody& b, const Quatd& q, const Vec3d& momentum, double h) {
    const Vec3d k1 = spin_of(b, q, momentum) * h;
    const Vec3d k2 = spin_of(b, turn(k1 * 0.5) * q, momentum) * h;
    const Vec3d k3 = spin_of(b, turn(k2 * 0.5 - cross(k1, k2) * 0.125) * q, momentum) * h;
    const Vec3d k4 = spin_of(b, turn(k3) * q, momentum) * h;
    const Vec3d sum = (k1 + k2 * 2.0 + k3 * 2.0 + k4) / 6.0;
    return turn(sum - cross(k1, k4) / 12.0) * q;
}

}  // namespace

RigidState state_at(const RigidBody& b, const Path& path, double time) {
    const RigidState& s = path.from;
    const double seconds = time - path.begin;
    RigidState out = s;
    out.position = position_at(path, seconds);
    out.velocity = velocity_at(path, seconds);
    if (!path.free || is_isotropic(b.inertia)) {
        out.orientation = normalize(turn(s.spin * seconds) * s.orientation);
        return out;
    }
    const Vec3d momentum = angular_momentum(b, s);
    constexpr double largest_turn = 0.02;  // radians a step: an error of 1e-9 a turn
    const int steps = std::max(1, int(std::ceil(length(s.spin) * std::abs(seconds) / largest_turn)));
    for (int i = 0; i < steps; ++i) out.orientation = normalize(tumble(b, out.orientation, momentum, seconds / steps));
    out.spin = spin_of(b, out.orientation, momentum);
    return out;
}

RigidState state_at(const RigidBody& b, const Track& track, double time) {
    const auto after =
        std::upper_bound(track.begin(), track.end(), time, [](double t, const Path& p) { return t < p.begin; });
    return state_at(b, after == track.begin() ? *after : *(after - 1), time);
}

}  // namespace drt
