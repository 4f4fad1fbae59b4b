#pragma once
// The view at a time, for scalars and lanes alike (included by camera_model.h).

#include "drt/camera/camera_model.h"

namespace drt {

/// A Bezier curve in Bernstein form, by Horner's scheme with running binomials (Farin, "Curves and Surfaces for CAGD"):
/// no buffer, so any number of points.
template <class T>
Vec3<T> bezier(const std::vector<Vec3<ScalarOf<T>>>& points, const T& s) {
    using Real = ScalarOf<T>;
    const size_t degree = points.size() - 1;
    if (degree == 0) return Vec3<T>(points[0]);
    const T r = T(1) - s;
    T term(1);  // binomial(degree, i) s^i
    Vec3<T> sum = Vec3<T>(points[0]) * r;
    for (size_t i = 1; i < degree; ++i) {
        term = term * s * T(Real(degree - i + 1) / Real(i));
        sum = (sum + Vec3<T>(points[i]) * term) * r;
    }
    return sum + Vec3<T>(points[degree]) * (term * s * T(1 / Real(degree)));
}

template <class T>
View<T> view_at(const CameraModel<ScalarOf<T>>& c, const T& u) {
    using Real = ScalarOf<T>;
    const T s = T(Real(c.s0)) + u * T(Real(c.s1 - c.s0));
    const auto lerp = [&](double a, double b) { return T(Real(a)) + u * T(Real(b - a)); };
    View<T> v;
    v.eye = bezier(c.eyes, s);
    Vec3<T> towards = bezier(c.targets, s) - v.eye;
    Vec3<T> up{lerp(c.up.start.x, c.up.end.x), lerp(c.up.start.y, c.up.end.y), lerp(c.up.start.z, c.up.end.z)};
    const T target_distance = length(towards);
    if (!c.path.empty()) {
        const Pose<T> pose = pose_at(std::span<const MotionPiece<Real>>(c.path), u);
        v.eye = pose.center;
        towards = rotate(pose.orientation, towards);
        up = rotate(pose.orientation, up);
    }
    v.forward = towards / target_distance;
    v.right = normalize(cross(v.forward, up));
    v.up = cross(v.right, v.forward);
    // tan(fov / 2) by sincos: the half angle in turns is fov / (4 pi)
    const auto [sine, cosine] = sincos_2pi(lerp(c.fov.start / (4 * pi<double>), c.fov.end / (4 * pi<double>)));
    v.pixel_size = sine / cosine * T(Real(2) / Real(c.film.width));
    const T focus = lerp(c.focus.start, c.focus.end);
    v.focus = select(focus > T(0), focus, target_distance);
    return v;
}

}  // namespace drt
