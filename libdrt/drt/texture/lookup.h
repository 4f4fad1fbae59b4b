#pragma once
// Filtered texture lookup, for one ray or for lanes of rays. No allocation, no lock, no branch per lane.
//
// The filter. A footprint is a parallelogram in texture space. Only its second moments matter here: they are those of
// a rectangle whose sides are the singular values of the footprint, `major` and `minor`. Up to max_taps samples are
// laid along the major axis, and each blends two levels of the pyramid such that the VARIANCE of the whole filter is
// that of the footprint convolved with the picture's own bilinear interpolation:
//
//   a lookup in a level whose texels are s base texels wide has the variance  s^2/6 (bilinear tent) + (s^2 - 1)/12
//   (the texel's average); the footprint's share w of a sample asks for  1/6 + w^2/12.  Hence  s^2 = 1 + w^2/3,
//
// and as variances of blended filters add linearly, the weight of the coarser level is linear in s^2 too. At w = 0 this
// is plain bilinear interpolation and it goes over into the mean colour without a seam. (Trilinear filtering with
// s = w, as on GPUs, has up to three times the variance. Anisotropic taps after Barkans, "High-quality rendering using
// the Talisman architecture", 1997.)

#include "drt/base/vec.h"
#include "drt/texture/texture_map.h"

namespace drt {

inline constexpr int max_taps = 8;

namespace texture_detail {

/// A level of the pyramid per lane.
template <class T>
struct LevelOf {
    using Int = Rebind<T, std::int32_t>;
    Int width, height, offset;
};

template <class T>
[[gnu::always_inline]] inline LevelOf<T> broadcast(const TextureMap::Level& l) {
    using Int = Rebind<T, std::int32_t>;
    return {Int(l.width), Int(l.height), Int(l.offset)};
}

template <class T>
[[gnu::always_inline]] inline T finite_or(const T& v, float otherwise) {
    return select(isfinite_lanes(v), v, T(otherwise));
}

/// The fractional part, in [0, 1] (1 only when a tiny negative value rounds up).
template <class T>
[[gnu::always_inline]] inline T repeat(const T& u) {
    using std::floor;
    return u - floor(u);
}

template <class T>
[[gnu::always_inline]] inline T blend(const T& a, const T& b, const T& weight) {
    return a + weight * (b - a);
}

template <class T>
[[gnu::always_inline]] inline Color3<T> blend(const Color3<T>& a, const Color3<T>& b, const T& weight) {
    return {blend(a.r, b.r, weight), blend(a.g, b.g, weight), blend(a.b, b.b, weight)};
}

/// The two texels between whose centres a coordinate in [0, 1] lies, and how far from the first.
template <class T>
struct Neighbours {
    Rebind<T, std::int32_t> first, second;
    T weight;
};

template <class T>
[[gnu::always_inline]] inline Neighbours<T> neighbours(const T& coordinate, const Rebind<T, std::int32_t>& side) {
    using std::floor;
    using Int = Rebind<T, std::int32_t>;
    const T x = coordinate * num_cast<T>(side) - T(0.5f);
    const T below = floor(x);
    const Int i = num_cast<Int>(below);  // in [-1, side - 1]
    const Int next = i + Int(1);
    return {select(i < Int(0), Int(i + side), i), select(next == side, Int(0), next), x - below};
}

/// One channel of four texels: upper left, upper right, lower left, lower right.
template <class T, class Int>
[[gnu::always_inline]] inline T interpolate(const float* channel, const Int (&corners)[4], const T& x, const T& y) {
    const T above = blend(gather<T>(channel, corners[0]), gather<T>(channel, corners[1]), x);
    const T below = blend(gather<T>(channel, corners[2]), gather<T>(channel, corners[3]), x);
    return blend(above, below, y);
}

/// uv in [0, 1].
template <class T>
[[gnu::always_inline]] inline Color3<T> bilinear(const TextureMap& map, const LevelOf<T>& level, const Vec2<T>& uv) {
    using Int = Rebind<T, std::int32_t>;
    const Neighbours<T> x = neighbours(uv.x, level.width), y = neighbours(uv.y, level.height);
    const Int size(floats_per_texel);
    const Int upper = level.offset + y.first * level.width * size, lower = level.offset + y.second * level.width * size;
    const Int left = x.first * size, right = x.second * size;
    const Int corners[] = {upper + left, upper + right, lower + left, lower + right};
    const float* texels = map.texels.data();
    return {interpolate(texels, corners, x.weight, y.weight), interpolate(texels + 1, corners, x.weight, y.weight),
            interpolate(texels + 2, corners, x.weight, y.weight)};
}

/// What to read for a footprint: samples along an axis, each from two levels.
template <class T>
struct Plan {
    T taps;        // 1 ... max_taps, whole
    Vec2<T> step;  // from tap to tap, in uv
    LevelOf<T> fine, coarse;
    T coarse_weight;
};

/// The two levels around texels `sqrt(size2)` base texels wide, size2 >= 1.
template <class T>
[[gnu::always_inline]] inline void choose_levels(const TextureMap& map, const T& size2, Plan<T>& plan) {
    using Int = Rebind<T, std::int32_t>;
    LevelOf<T> fine = broadcast<T>(map.levels[0]);
    LevelOf<T> coarse = broadcast<T>(map.levels[map.levels.size() > 1 ? 1 : 0]);
    T span2(1.0f);  // the squared texel size of `fine`
    float power = 4.0f;
    for (size_t l = 1; l < map.levels.size(); ++l, power *= 4.0f) {
        const MaskOf<T> reached = size2 >= T(power);
        if (!any(reached)) break;
        const MaskOf<Int> m = mask_cast<Int>(reached);
        const LevelOf<T> here = broadcast<T>(map.levels[l]);
        const LevelOf<T> next = broadcast<T>(map.levels[l + 1 < map.levels.size() ? l + 1 : l]);
        fine = {select(m, here.width, fine.width), select(m, here.height, fine.height),
                select(m, here.offset, fine.offset)};
        coarse = {select(m, next.width, coarse.width), select(m, next.height, coarse.height),
                  select(m, next.offset, coarse.offset)};
        span2 = select(reached, T(power), span2);
    }
    plan.fine = fine;
    plan.coarse = coarse;
    plan.coarse_weight = min(T((size2 / span2 - T(1.0f)) * T(1.0f / 3.0f)), T(1.0f));  // 1 only beyond the last level
}

/// A component of the footprint in texels. One that is not a number, or as large as the limit, sees the mean colour;
/// the limit's fourth power is still finite.
template <class T>
[[gnu::always_inline]] inline T to_texels(const T& v, const T& side) {
    constexpr float limit = 1e8f;
    return clamp(finite_or(T(v * side), limit), T(-limit), T(limit));
}

/// d1, d2: the footprint's sides in uv.
template <class T>
[[gnu::always_inline]] inline Plan<T> plan_lookup(const TextureMap& map, const Vec2<T>& d1, const Vec2<T>& d2) {
    using std::ceil, std::sqrt;
    const T width(float(map.levels[0].width)), height(float(map.levels[0].height));
    const T ax = to_texels(d1.x, width), ay = to_texels(d1.y, height), bx = to_texels(d2.x, width),
            by = to_texels(d2.y, height);

    // Eigenvalues of J J^T, J = [d1 d2]: the squared singular values. The smaller one by the determinant, which keeps
    // its digits when the footprint is thin.
    const T xx = ax * ax + bx * bx, yy = ay * ay + by * by, xy = ax * ay + bx * by;
    const T half_difference = (xx - yy) * T(0.5f);
    const T root = sqrt(T(half_difference * half_difference + xy * xy));
    const T major2 = (xx + yy) * T(0.5f) + root;
    const T area = ax * by - bx * ay;
    const T minor2 = select(major2 > T(0.0f), T(area * area / max(major2, T(1e-30f))), T(0.0f));

    Plan<T> plan;
    // As many samples as the footprint is longer than wide; a sixteenth more is not worth another one.
    const T ratio = sqrt(T(major2 / max(minor2, T(1.0f))));
    plan.taps = clamp(T(ceil(T(ratio - T(0.0625f)))), T(1.0f), T(float(max_taps)));
    const T share2 = max(minor2, T(major2 / (plan.taps * plan.taps)));
    choose_levels(map, T(T(1.0f) + share2 * T(1.0f / 3.0f)), plan);

    // The eigenvector of the larger one, written so that nothing cancels.
    const MaskOf<T> wide = half_difference >= T(0.0f);
    const T ex = select(wide, T(half_difference + root), xy), ey = select(wide, xy, T(root - half_difference));
    const T length2 = ex * ex + ey * ey;
    const T scale = select(length2 > T(0.0f), T(sqrt(T(major2 / max(length2, T(1e-30f)))) / plan.taps), T(0.0f));
    plan.step = {ex * scale / width, ey * scale / height};
    return plan;
}

}  // namespace texture_detail

/// The picture at a point, interpolated bilinearly. T is float or lanes of float. uv: any number; NaN and infinity
/// count as 0.
template <class T>
Color3<T> lookup(const TextureMap& map, const Vec2<T>& uv) {
    using namespace texture_detail;
    static_assert(std::is_same_v<ScalarOf<T>, float>);
    const Vec2<T> inside = {repeat(finite_or(uv.x, 0.0f)), repeat(finite_or(uv.y, 0.0f))};
    return bilinear(map, broadcast<T>(map.levels[0]), inside);
}

/// The mean of the picture over a footprint: the parallelogram centred at uv with the sides d1 and d2 (in uv, full
/// widths, any two that span it), for example the derivatives of uv by the image's x and y times the pixel's share.
/// Zero sides give lookup(map, uv), huge ones the mean colour.
template <class T>
Color3<T> lookup(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& d1, const Vec2<T>& d2) {
    using namespace texture_detail;
    static_assert(std::is_same_v<ScalarOf<T>, float>);
    const Plan<T> plan = plan_lookup(map, d1, d2);
    const Vec2<T> centre = {finite_or(uv.x, 0.0f), finite_or(uv.y, 0.0f)};
    const bool two_levels = any(plan.coarse_weight > T(0.0f));
    const int taps = int(reduce_max(plan.taps));
    const T weight = T(1.0f) / plan.taps;
    const T first = (T(1.0f) - plan.taps) * T(0.5f);
    Color3<T> sum(T(0.0f));
    for (int i = 0; i < taps; ++i) {
        const T place = first + T(float(i));
        const Vec2<T> uv_i = {repeat(T(centre.x + plan.step.x * place)), repeat(T(centre.y + plan.step.y * place))};
        Color3<T> color = bilinear(map, plan.fine, uv_i);
        if (two_levels) color = blend(color, bilinear(map, plan.coarse, uv_i), plan.coarse_weight);
        sum += color * select(T(float(i)) < plan.taps, weight, T(0.0f));
    }
    return sum;
}

}  // namespace drt
