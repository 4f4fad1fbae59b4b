#pragma once
// Uniform directions to a triangle: Arvo, "Stratified Sampling of Spherical Triangles", 1995, in the form of Peters,
// "BRDF Importance Sampling for Polygonal Lights", 2021: one arc tangent, no arc cosines, and nothing that cancels when
// the triangle is small.

#include <limits>

#include "drt/base/math.h"
#include "drt/base/vec.h"

namespace drt {

/// Of unit vectors a, b, c. With x on the arc from a to c, tan(area(a, b, x) / 2) is
/// det(a, b, x) / (1 + a.b + (a + b).x): Van Oosterom and Strackee.
template <class T>
struct SphericalTriangle {
    Vec3<T> a, b, c;
    T det;        ///< |det(a, b, c)|
    T a_b, ab_c;  ///< 1 + a.b, (a + b).c
    T area;       ///< steradians
};

/// `det` is known better to the caller than from the unit vectors, where it cancels.
template <class T>
[[gnu::always_inline]] inline SphericalTriangle<T> spherical_triangle(const Vec3<T>& a, const Vec3<T>& b,
                                                                      const Vec3<T>& c, const T& det) {
    using F = Rebind<T, float>;
    SphericalTriangle<T> t{a, b, c, det, T(1) + dot(a, b), dot(a, c) + dot(b, c), T(0)};
    // The arc tangent in float: relative error 2e-7 is enough, also for double.
    t.area = num_cast<T>(fast_atan2(num_cast<F>(t.det), num_cast<F>(T(t.a_b + t.ab_c)))) * T(2);
    return t;
}

template <class T>
[[gnu::always_inline]] inline SphericalTriangle<T> select(const MaskOf<T>& m, const SphericalTriangle<T>& x,
                                                          const SphericalTriangle<T>& y) {
    return {select(m, x.a, y.a),     select(m, x.b, y.b),       select(m, x.c, y.c),      select(m, x.det, y.det),
            select(m, x.a_b, y.a_b), select(m, x.ab_c, y.ab_c), select(m, x.area, y.area)};
}

/// The direction for the part `area` of the triangle's area and u in [0, 1]: uniform in both.
template <class T>
[[gnu::always_inline]] inline Vec3<T> uniform_spherical_triangle(const SphericalTriangle<T>& t, const T& area,
                                                                 const T& u) {
    using std::sqrt;
    // x on the arc a..c, so that (a, b, x) has the area: a mirrored about the bisector m, for which the tangent of half
    // the area is a ratio of linear functions.
    const auto [s, c] = sincos_2pi(T(area * T(0.25f / pi<ScalarOf<T>>)));
    const Vec3<T> m = t.a * (t.det * c - t.ab_c * s) + t.c * (t.a_b * s);
    const T m2 = max(dot(m, m), T(std::numeric_limits<ScalarOf<T>>::min()));
    const Vec3<T> x = m * (T(2) * dot(t.a, m) / m2) - t.a;
    // On the arc b..x, 1 - cos of the angle to b uniform. 1 - cos and 1 + cos of the whole arc, neither by
    // cancellation: a vast light overhead has corners that are nearly opposite.
    const Vec3<T> gap = x - t.b, sum = x + t.b;
    const T h = dot(gap, gap) * T(0.5f), uh = u * h;
    const T rest = max(T(dot(sum, sum) * T(0.5f)), T(std::numeric_limits<ScalarOf<T>>::min()));
    const T along = sqrt(max(T(u * (T(2) - uh) / rest), T(0)));
    return t.b * (T(1) - uh - along * (T(1) - h)) + x * along;
}

}  // namespace drt
