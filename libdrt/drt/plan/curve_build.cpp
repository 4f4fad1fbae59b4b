#include "drt/plan/curve_build.h"

#include <algorithm>
#include <cmath>

#include "drt/base/constants.h"

namespace drt {

namespace {

double size_of(double v) { return std::abs(v); }
double size_of(const Vec3d& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// Coefficients of the polynomial of degree n - 1 that meets f at n Chebyshev points of the stretch (Trefethen,
// "Approximation Theory and Approximation Practice", chapters 2 to 4).
template <class V, class F>
Curve<V> interpolate(const F& f, const Stretch& s, size_t n) {
    std::vector<double> cosine(4 * n);  // of multiples of pi / 2n
    for (size_t i = 0; i < 4 * n; ++i) cosine[i] = std::cos(pi<double> / 2 * double(i) / double(n));
    Curve<V> c(n);
    for (size_t j = 0; j < n; ++j) {
        const size_t angle = 2 * j + 1;
        const double x = cosine[angle % (4 * n)];
        const V value = f(0.5 * (s.from * (1 - x) + s.to * (1 + x)));
        for (size_t k = 0; k < n; ++k)
            c[k] = c[k] + value * (cosine[k * angle % (4 * n)] * (k == 0 ? 1.0 : 2.0) / double(n));
    }
    return c;
}

// By doubling until the last terms are rounding, or until there are as many as a polynomial of degree `degree` has.
// `size` is that of the values of f.
template <class V, class F>
Curve<V> fit(const F& f, const Stretch& s, size_t degree, double size) {
    if (s.from == s.to || degree == 0) return {f(s.from)};
    const double rounding = 1e-15 * size;
    const auto is_rounding = [&](const V& c) { return size_of(c) <= rounding; };
    for (size_t n = 5;; n = 2 * n - 1) {
        const bool is_exact = n > degree;
        Curve<V> c = interpolate<V>(f, s, is_exact ? degree + 1 : n);
        const size_t tail = std::min<size_t>(3, c.size() - 1);
        if (!is_exact && !std::all_of(c.end() - std::ptrdiff_t(tail), c.end(), is_rounding)) continue;
        while (c.size() > 1 && is_rounding(c.back())) c.pop_back();
        return c;
    }
}

}  // namespace

// Farin's Bernstein form as weighted mean of the points. The weights' ratios are simple, and from the largest weight
// outwards they only fall: nothing overflows, and what underflows does not matter. Their common factor cancels.
Vec3d bezier_point(const std::vector<Vec3d>& points, double s) {
    const size_t degree = points.size() - 1;
    if (s <= 0) return points.front();
    if (s >= 1) return points.back();
    constexpr double negligible = 1e-40;
    const double ratio = s / (1 - s);
    const size_t largest = std::min(degree, size_t(double(degree + 1) * s));
    double sum = 1;
    Vec3d mean = points[largest];
    double weight = 1;
    for (size_t i = largest; i < degree && weight > negligible; ++i) {
        weight *= ratio * double(degree - i) / double(i + 1);
        sum += weight;
        mean += points[i + 1] * weight;
    }
    weight = 1;
    for (size_t i = largest; i > 0 && weight > negligible; --i) {
        weight *= double(i) / (ratio * double(degree - i + 1));
        sum += weight;
        mean += points[i - 1] * weight;
    }
    return mean / sum;
}

Curve<Vec3d> bezier_curve(const std::vector<Vec3d>& points, const Stretch& s) {
    const Vec3d origin = points.front();  // differences keep their digits far from the coordinates' origin
    std::vector<Vec3d> from_origin;
    double size = 0;
    for (const Vec3d& p : points) {
        from_origin.push_back(p - origin);
        size = std::max(size, size_of(from_origin.back()));
    }
    if (size == 0) return {origin};
    Curve<Vec3d> c = fit<Vec3d>([&](double at) { return bezier_point(from_origin, at); }, s, points.size() - 1, size);
    c[0] += origin;
    return c;
}

namespace {

// A quarter turn's sine and cosine: the next term is below 1e-17.
constexpr size_t enough_for_angles = 16;

}  // namespace

Curve<double> sine_curve(double start, double end, const Stretch& s) {
    const double size = std::sin(std::max(start, end));
    return fit<double>([&](double at) { return std::sin(start + (end - start) * at); }, s, enough_for_angles, size);
}

Curve<double> cosine_curve(double start, double end, const Stretch& s) {
    return fit<double>([&](double at) { return std::cos(start + (end - start) * at); }, s, enough_for_angles, 1);
}

}  // namespace drt
