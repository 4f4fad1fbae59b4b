#pragma once
// Maps of the unit square to the shapes a renderer samples. All are continuous or nearly so and keep the square's
// stratification: points that are close in the square stay close. `u` is in [0, 1)^2.

#include "drt/base/math.h"
#include "drt/base/vec.h"

namespace drt {

/// The unit disc, uniform: density 1 / pi. Concentric map: Shirley and Chiu, "A Low Distortion Map Between Disk and
/// Square", JGT 2(3), 1997.
template <class T>
[[gnu::always_inline]] inline Vec2<T> uniform_disc(const Vec2<T>& u) {
    const T a = T(2) * u.x - T(1);
    const T b = T(2) * u.y - T(1);
    const auto wide = a * a > b * b;
    const T radius = select(wide, a, b);  // signed: the turn below is at most 1/8
    const T other = select(wide, b, a);
    const T turn = select(radius == T(0), T(0), T(other / radius)) * T(0.125f);
    const auto [s, c] = sincos_2pi(turn);
    return {radius * select(wide, c, s), radius * select(wide, s, c)};
}

/// The unit disc with the *radius* uniform in [0, 1): denser in the middle, density 1 / (2 pi r). The legacy lens and
/// bulb. u.x is the radius, u.y the azimuth in turns.
template <class T>
[[gnu::always_inline]] inline Vec2<T> radial_disc(const Vec2<T>& u) {
    const auto [s, c] = sincos_2pi(u.y);
    return {u.x * c, u.x * s};
}

/// Barycentric weights of the second and third vertex, uniform over a triangle. Heitz, "A Low-Distortion Map Between
/// Triangle and Square", 2019: folds the square along its diagonal, without the square root's uneven stretching.
template <class T>
[[gnu::always_inline]] inline Vec2<T> uniform_triangle(const Vec2<T>& u) {
    const auto upper = u.y > u.x;
    const T x = select(upper, T(u.x * T(0.5f)), T(u.x - u.y * T(0.5f)));
    const T y = select(upper, T(u.y - u.x * T(0.5f)), T(u.y * T(0.5f)));
    return {x, y};
}

/// A unit direction around local z.
template <class T>
struct LocalDirection {
    Vec3<T> direction;
    T one_minus_cos;  ///< of the angle to z, without cancellation
};

/// 1 - cos of the angle whose sine is `sin_angle` (in [0, pi/2]), without cancellation: a light of angular radius 1e-7
/// keeps all its digits.
template <class T>
[[gnu::always_inline]] inline T one_minus_cos_from_sin(const T& sin_angle) {
    using std::sqrt;
    const T s2 = min(T(sin_angle * sin_angle), T(1));
    return s2 / (T(1) + sqrt(T(1) - s2));
}

/// Steradians of the cone with half angle asin(sin_max) <= pi/2; its inverse is uniform_cone's pdf.
template <class T>
[[gnu::always_inline]] inline T cone_solid_angle(const T& sin_max) {
    return T(2 * pi<ScalarOf<T>>) * one_minus_cos_from_sin(sin_max);
}

/// Uniform over the directions around z with 1 - cos <= cap <= 2: density 1 / (2 pi cap). The concentric disc lifted to
/// the cap: 1 - cos grows with the disc's area.
template <class T>
[[gnu::always_inline]] inline LocalDirection<T> uniform_cap(const Vec2<T>& u, const T& cap) {
    using std::sqrt;
    const Vec2<T> disc = uniform_disc(u);
    const T w = (disc.x * disc.x + disc.y * disc.y) * cap;
    const T stretch = sqrt(max(T(cap * (T(2) - w)), T(0)));  // sin(theta) / disc radius
    return {{disc.x * stretch, disc.y * stretch, T(1) - w}, w};
}

/// Uniform over the cone around z with half angle asin(sin_max) <= pi/2: the directions from a point to a sphere of
/// radius r at distance d, sin_max = r/d.
template <class T>
[[gnu::always_inline]] inline LocalDirection<T> uniform_cone(const Vec2<T>& u, const T& sin_max) {
    return uniform_cap(u, one_minus_cos_from_sin(sin_max));
}

/// A direction around local z with density (n + 1) / (2 pi) cos^n, n >= 0: a Phong lobe; n = 0 the uniform, n = 1 the
/// cosine-weighted hemisphere. 1 - cos = 1 - u^(1/(n+1)) by expm1: as precise at n = 1e9 as at 1.
template <class T>
[[gnu::always_inline]] inline LocalDirection<T> power_cosine(const Vec2<T>& u, const T& n) {
    using std::sqrt;
    const Vec2<T> disc = uniform_disc(u);
    const T r2 = min(T(disc.x * disc.x + disc.y * disc.y), T(1));
    const T w = -fast_expm1(T(fast_log1p(T(-r2)) / (n + T(1))));
    const T sin_theta = sqrt(max(T(w * (T(2) - w)), T(0)));
    const T stretch = select(r2 > T(0), T(sin_theta / sqrt(r2)), T(0));
    return {{disc.x * stretch, disc.y * stretch, T(1) - w}, w};
}

/// The pdf of power_cosine in solid angle.
template <class T>
[[gnu::always_inline]] inline T power_cosine_pdf(const T& one_minus_cos, const T& n) {
    return (n + T(1)) * T(1 / (2 * pi<ScalarOf<T>>)) * pow_one_minus(one_minus_cos, n);
}

}  // namespace drt
