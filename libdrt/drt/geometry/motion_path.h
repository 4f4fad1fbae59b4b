#pragma once
// A rigid body's path over the exposure, exact to the keyframes' interpolation: pieces of cubic polynomials for the
// centre and of uniform turns for the orientation, both in ray time u in [0, 1].

#include <span>
#include <vector>

#include "drt/base/constants.h"
#include "drt/base/math.h"
#include "drt/base/quat.h"

namespace drt {

/// Covers u in [begin, begin + 1 / inv_length) with the local parameter s = (u - begin) * inv_length in [0, 1].
template <class Real>
struct MotionPiece {
    Real begin = 0, inv_length = 1;
    Vec3<Real> c0, c1, c2, c3;  ///< centre = c0 + s (c1 + s (c2 + s c3)), about the same origin as all coordinates
    Quat<Real> q0;              ///< orientation at s = 0
    Vec3<Real> axis{0, 0, 1};   ///< unit world axis of the turn
    Real angle = 0;             ///< radians turned from s = 0 to s = 1, any size
};

template <class To, class From>
MotionPiece<To> cast(const MotionPiece<From>& p) {
    return {To(p.begin),    To(p.inv_length), Vec3<To>(p.c0),   Vec3<To>(p.c1), Vec3<To>(p.c2),
            Vec3<To>(p.c3), Quat<To>(p.q0),   Vec3<To>(p.axis), To(p.angle)};
}

/// Where a body is and how it is turned, relative to its description.
template <class T>
struct Pose {
    Vec3<T> center;
    Quat<T> orientation;
};

namespace detail {

template <class T>
Vec3<T> piece_center(const MotionPiece<ScalarOf<T>>& p, const T& s) {
    return Vec3<T>(p.c0) + s * (Vec3<T>(p.c1) + s * (Vec3<T>(p.c2) + s * Vec3<T>(p.c3)));
}

template <class T>
Quat<T> piece_orientation(const MotionPiece<ScalarOf<T>>& p, const T& s) {
    using Real = ScalarOf<T>;
    if (p.angle == 0) return Quat<T>(p.q0);
    const T half_turns = s * T(p.angle / (4 * pi<Real>));  // angle / 2 in units of full turns
    const auto [sine, cosine] = sincos_2pi(half_turns);
    const Vec3<T> v = Vec3<T>(p.axis) * sine;
    return Quat<T>{cosine, v.x, v.y, v.z} * Quat<T>(p.q0);
}

template <class T>
T local_parameter(const MotionPiece<ScalarOf<T>>& p, const T& u) {
    return clamp((u - T(p.begin)) * T(p.inv_length), T(0), T(1));
}

}  // namespace detail

template <class T>
Pose<T> pose_at(std::span<const MotionPiece<ScalarOf<T>>> pieces, const T& u) {
    using namespace detail;
    const T s = local_parameter(pieces[0], u);
    Pose<T> pose{piece_center(pieces[0], s), piece_orientation(pieces[0], s)};
    for (size_t i = 1; i < pieces.size(); ++i) {
        const auto here = u >= T(pieces[i].begin);
        if (!any(here)) break;  // pieces ascend
        const T si = local_parameter(pieces[i], u);
        const Quat<T> q = piece_orientation(pieces[i], si);
        pose.center = select(here, piece_center(pieces[i], si), pose.center);
        pose.orientation = {select(here, q.w, pose.orientation.w), select(here, q.x, pose.orientation.x),
                            select(here, q.y, pose.orientation.y), select(here, q.z, pose.orientation.z)};
    }
    return pose;
}

/// The centre alone, for bodies whose orientation does not matter (spheres).
template <class T>
[[gnu::always_inline]] inline Vec3<T> center_at(std::span<const MotionPiece<ScalarOf<T>>> pieces, const T& u) {
    using namespace detail;
    Vec3<T> center = piece_center(pieces[0], local_parameter(pieces[0], u));
    for (size_t i = 1; i < pieces.size(); ++i) {
        const auto here = u >= T(pieces[i].begin);
        if (!any(here)) break;
        center = select(here, piece_center(pieces[i], local_parameter(pieces[i], u)), center);
    }
    return center;
}

}  // namespace drt
