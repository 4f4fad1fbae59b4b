#pragma once
// Pixel filters by importance sampling: a sample's offset from its pixel's centre is drawn with density |f|, so every
// sample lands in exactly one pixel and needs no neighbours (Ernst, Stamminger and Greiner, "Filter Importance
// Sampling", 2006). Filters are separable: each axis by itself, monotone, so a stratified point stays stratified.

#include <vector>

#include "drt/base/vec.h"
#include "drt/sampling/octave_quantiles.h"

namespace drt {

enum class FilterKind { point, box, triangle, gaussian, blackman_harris, mitchell };

struct FilterSpec {
    FilterKind kind = FilterKind::blackman_harris;
    double radius = 1.5;  ///< pixels, > 0; where the filter is cut off. `point` ignores it.
    double sigma = 0.5;   ///< pixels, > 0; gaussian only
};

/// The filter along one axis at x pixels from the centre; 0 from `radius` on. The Gaussian is the normal density, cut
/// off and not rescaled; Mitchell has B = C = 1/3, stretched from radius 2. A point filter is 0 everywhere.
double filter_value(const FilterSpec&, double x);

/// A part of the filter's half line where |f| is positive inside, sampled away from its higher end.
struct FilterPiece {
    float start = 0, direction = 1;  ///< x = start + direction * quantile(v)
    float v0 = 1, v1 = -1;           ///< v = v0 + v1 * a, a in [0, 1) the fraction of |f| nearer to the centre
    float from = 0;                  ///< the a from which on this piece holds
    float sign = 1;                  ///< of f
    OctaveQuantiles quantiles;
};

struct FilterTable {
    FilterSpec spec;
    std::vector<FilterPiece> pieces;  ///< by rising `from`; none for point, box, triangle
    double integral = 1;              ///< of f along an axis
    double absolute_integral = 1;     ///< of |f|
    float weight = 1;                 ///< of a sample along an axis, without its sign: the ratio of the two
};

FilterTable make_filter(const FilterSpec&);

template <class T>
struct FilterSample {
    Vec2<T> offset;  ///< pixels from the pixel's centre
    T weight;        ///< 1 for filters without negative lobes; its mean is 1 for all
};

namespace filter_detail {

template <class T>
struct AxisSample {
    T offset, weight;
};

template <class T>
[[gnu::always_inline]] inline AxisSample<T> sample_pieces(const FilterTable& filter, const T& a) {
    AxisSample<T> sample;
    for (size_t i = 0; i < filter.pieces.size(); ++i) {
        const FilterPiece& p = filter.pieces[i];
        const T x = T(p.start) + T(p.direction) * quantile(p.quantiles, mul_add(T(p.v1), a, T(p.v0)));
        const T weight(p.sign * filter.weight);
        if (i == 0) {
            sample = {x, weight};
            continue;
        }
        const auto here = a >= T(p.from);
        sample = {select(here, x, sample.offset), select(here, weight, sample.weight)};
    }
    return sample;
}

template <class T>
[[gnu::always_inline]] inline AxisSample<T> sample_axis(const FilterTable& filter, const T& u) {
    using std::sqrt;
    const T radius = T(float(filter.spec.radius));
    const T s = T(2) * u - T(1);
    if (filter.spec.kind == FilterKind::point) return {T(0), T(1)};
    if (filter.spec.kind == FilterKind::box) return {radius * s, T(1)};
    const auto left = s < T(0);
    const T a = select(left, T(-s), s);
    AxisSample<T> sample = filter.spec.kind == FilterKind::triangle
                               ? AxisSample<T>{radius * (T(1) - T(sqrt(T(1) - a))), T(1)}
                               : sample_pieces(filter, a);
    sample.offset = select(left, T(-sample.offset), sample.offset);
    return sample;
}

}  // namespace filter_detail

/// u in [0, 1)^2; T is float or its lanes.
template <class T>
[[gnu::always_inline]] inline FilterSample<T> sample_filter(const FilterTable& filter, const Vec2<T>& u) {
    const auto x = filter_detail::sample_axis(filter, u.x), y = filter_detail::sample_axis(filter, u.y);
    return {{x.offset, y.offset}, x.weight * y.weight};
}

}  // namespace drt
