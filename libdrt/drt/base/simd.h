#pragma once
// SIMD lanes. Code in the hot path is written once, as templates over the number type T: a scalar (tests, the
// one-ray fallback) or Lane<float, W> / Lane<double, W>. std::experimental::simd is the lane type; the helpers here
// are the few things it lacks or spells awkwardly, each with a scalar twin so that templates need no special case.

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <experimental/simd>
#include <limits>
#include <type_traits>

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace drt {

namespace stdx = std::experimental;

template <class T, int W>
using Lane = stdx::simd<T, stdx::simd_abi::deduce_t<T, W>>;

/// Lanes of the machine's width for rays whose geometry is in Real; at least 4, the smallest Embree packet.
template <class Real>
inline constexpr int native_width = []() {
    constexpr int native = int(stdx::native_simd<Real>::size());
    return native < 4 ? 4 : native;
}();

template <class T>
struct LaneTraits {
    static constexpr int width = 1;
    using Scalar = T;
    using Mask = bool;
    template <class U>
    using Rebind = U;
};

template <class S, class Abi>
struct LaneTraits<stdx::simd<S, Abi>> {
    static constexpr int width = int(stdx::simd<S, Abi>::size());
    using Scalar = S;
    using Mask = typename stdx::simd<S, Abi>::mask_type;
    template <class U>
    using Rebind = Lane<U, width>;
};

template <class T>
using MaskOf = typename LaneTraits<T>::Mask;
template <class T>
using ScalarOf = typename LaneTraits<T>::Scalar;
/// The same number of lanes of another scalar type.
template <class T, class U>
using Rebind = typename LaneTraits<T>::template Rebind<U>;
template <class T>
inline constexpr int width_of = LaneTraits<T>::width;
template <class T>
inline constexpr bool is_lane = width_of<T> != 1 || !std::is_arithmetic_v<T>;

/// The lane types of rays whose geometry is in Real: R geometry, F colours and times, I ids, U bits.
template <class Real>
struct Pack {
    static constexpr int width = native_width<Real>;
    using R = Lane<Real, width>;
    using F = Lane<float, width>;
    using I = Lane<std::int32_t, width>;
    using U = Lane<std::uint32_t, width>;
    using Mask = typename F::mask_type;
};

// The helpers are always_inline: left to its own limits, GCC 12 calls them, with every operand through memory, which
// made the texture lookup (benchmarks/texture_bench) 2.5 times slower.

// ---- conversions ------------------------------------------------------------------------------------------------

/// Scalar to scalar, scalar to lanes (broadcast), lanes to lanes. Float to int truncates.
template <class To, class From>
[[gnu::always_inline]] constexpr To num_cast(const From& v) {
    if constexpr (std::is_same_v<To, From>)
        return v;
    else if constexpr (!is_lane<From>)
        return To(static_cast<ScalarOf<To>>(v));
    else
        return stdx::static_simd_cast<To>(v);
}

/// A mask of lanes of one type as the mask of lanes of another (float compare, int select).
template <class To, class M>
[[gnu::always_inline]] inline MaskOf<To> mask_cast(const M& m) {
    if constexpr (std::is_same_v<MaskOf<To>, M>)
        return m;
    else if constexpr (std::is_same_v<M, bool>)
        return MaskOf<To>(m);
    else
        return stdx::__proposed::static_simd_cast<MaskOf<To>>(m);
}

// ---- selection and reduction -----------------------------------------------------------------------------------

template <class T>
[[gnu::always_inline]] inline T select(const MaskOf<T>& m, const T& a, const T& b) {
    if constexpr (!is_lane<T>)
        return m ? a : b;
    else {
        T r = b;
        stdx::where(m, r) = a;
        return r;
    }
}

template <class M>
[[gnu::always_inline]] inline bool any(const M& m) {
    if constexpr (std::is_same_v<M, bool>)
        return m;
    else
        return stdx::any_of(m);
}

template <class M>
[[gnu::always_inline]] inline bool all(const M& m) {
    if constexpr (std::is_same_v<M, bool>)
        return m;
    else
        return stdx::all_of(m);
}

template <class M>
[[gnu::always_inline]] inline int count(const M& m) {
    if constexpr (std::is_same_v<M, bool>)
        return m ? 1 : 0;
    else
        return stdx::popcount(m);
}

template <class M>
[[gnu::always_inline]] inline bool lane_bit(const M& m, int i) {
    if constexpr (std::is_same_v<M, bool>)
        return m;
    else
        return m[i];
}

template <class T>
[[gnu::always_inline]] inline ScalarOf<T> lane(const T& v, int i) {
    if constexpr (!is_lane<T>)
        return v;
    else
        return v[i];
}

// min, max and clamp are for operands that are not NaN. Scalars follow the comparison as written; on lanes overload
// resolution prefers those of std::experimental::simd, which GCC compiles as if there were no NaN (and no signed zero):
// with a NaN operand either operand may come out, whichever way round the compiler put them (one minps). The comparison
// and blend that would define it cost a second instruction on AVX-512, so whoever may meet a NaN tests for it first.
template <class T>
[[gnu::always_inline]] inline T min(const T& a, const T& b) {
    return select(a < b, a, b);
}
template <class T>
[[gnu::always_inline]] inline T max(const T& a, const T& b) {
    return select(a > b, a, b);
}
template <class T>
[[gnu::always_inline]] inline T clamp(const T& v, const T& lo, const T& hi) {
    return min(max(v, lo), hi);
}

template <class T>
[[gnu::always_inline]] inline ScalarOf<T> reduce_max(const T& v) {
    if constexpr (!is_lane<T>)
        return v;
    else
        return stdx::hmax(v);
}
template <class T>
[[gnu::always_inline]] inline ScalarOf<T> reduce_min(const T& v) {
    if constexpr (!is_lane<T>)
        return v;
    else
        return stdx::hmin(v);
}

/// 1 / sqrt(x) for x > 0 and finite; relative error below 2e-7 in float. AVX-512's estimate has 14 bits, which one step
/// of Newton's method doubles; that takes a third of the time of a square root and a division.
template <class T>
[[gnu::always_inline]] inline T inverse_sqrt(const T& x) {
    using std::sqrt;
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<ScalarOf<T>, float> && width_of<T> == 16) {
        const T y(_mm512_maskz_rsqrt14_ps(__mmask16(0xffff), static_cast<__m512>(x)));
        return y * (T(1.5f) - (x * T(0.5f)) * (y * y));
    }
#endif
    return T(1) / sqrt(x);
}

/// 1 / x for finite x whose inverse is finite too (0: infinity or NaN); relative error below 2e-7 in float. As
/// inverse_sqrt.
template <class T>
[[gnu::always_inline]] inline T reciprocal(const T& x) {
#if defined(__AVX512F__)
    if constexpr (std::is_same_v<ScalarOf<T>, float> && width_of<T> == 16) {
        const T y(_mm512_maskz_rcp14_ps(__mmask16(0xffff), static_cast<__m512>(x)));
        return y * (T(2) - x * y);
    }
#endif
    return T(1) / x;
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> isfinite_lanes(const T& v) {
    using S = ScalarOf<T>;
    using std::abs;
    return abs(v) <= T(std::numeric_limits<S>::max());
}

// ---- memory ----------------------------------------------------------------------------------------------------

template <class T>
[[gnu::always_inline]] inline T load(const ScalarOf<T>* p) {
    if constexpr (!is_lane<T>)
        return *p;
    else
        return T(p, stdx::element_aligned);
}

template <class T>
[[gnu::always_inline]] inline void store(const T& v, ScalarOf<T>* p) {
    if constexpr (!is_lane<T>)
        *p = v;
    else
        v.copy_to(p, stdx::element_aligned);
}

/// The lane numbers 0, 1, 2, ...
template <class T>
[[gnu::always_inline]] inline T iota() {
    if constexpr (!is_lane<T>)
        return T(0);
    else
        return T([](auto i) { return ScalarOf<T>(i); });
}

/// The first n lanes.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> first_lanes(int n) {
    if constexpr (!is_lane<T>)
        return n > 0;
    else
        return iota<T>() < T(ScalarOf<T>(n));
}

/// p[index] per lane. Every index must be valid, in masked-out lanes too (callers clamp or use 0).
template <class T, class S, class I>
[[gnu::always_inline]] inline T gather(const S* p, const I& index) {
    static_assert(std::is_same_v<S, ScalarOf<T>>);
    if constexpr (!is_lane<T>) return p[index];
#if defined(__AVX512F__)
    else if constexpr (std::is_same_v<S, float> && width_of<T> == 16)
        // the masked form: GCC 12 warns of an uninitialised source in the plain one
        return T(_mm512_mask_i32gather_ps(_mm512_setzero_ps(), __mmask16(0xffff), static_cast<__m512i>(index), p, 4));
    else if constexpr (std::is_same_v<S, std::int32_t> && width_of<T> == 16)
        return T(
            _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), __mmask16(0xffff), static_cast<__m512i>(index), p, 4));
#endif
#if defined(__AVX2__)
    else if constexpr (std::is_same_v<S, float> && width_of<T> == 8 && sizeof(index) == 32)
        return T(_mm256_i32gather_ps(p, static_cast<__m256i>(index), 4));
#endif
    else
        return T([&](auto i) { return p[index[i]]; });
}

/// p[index], p[index + 1], ... p[index + 3] per lane. On AVX-512 a lane's four are one load, and a transpose is half
/// the price of four gathers.
template <class T, class I>
[[gnu::always_inline]] inline std::array<T, 4> gather_quads(const float* p, const I& index) {
    static_assert(std::is_same_v<ScalarOf<T>, float>);
#if defined(__AVX512F__)
    if constexpr (width_of<T> == 16) {
        alignas(64) std::int32_t at[16];
        store(index, at);
        __asm__("" : "+m"(at));  // read back as addresses: GCC would take the register apart, at twice the price
        // Row r holds the quads of lanes r, r + 4, r + 8, r + 12: 4 x 4 transposes then leave the lanes in order.
        const auto row = [&](int r) {
            __m512 v = _mm512_castps128_ps512(_mm_loadu_ps(p + at[r]));
            v = _mm512_insertf32x4(v, _mm_loadu_ps(p + at[r + 4]), 1);
            v = _mm512_insertf32x4(v, _mm_loadu_ps(p + at[r + 8]), 2);
            return _mm512_castps_pd(_mm512_insertf32x4(v, _mm_loadu_ps(p + at[r + 12]), 3));
        };
        const auto pairs = [](const __m512d& a, const __m512d& b, bool upper) {
            const __m512 x = _mm512_castpd_ps(a), y = _mm512_castpd_ps(b);
            return _mm512_castps_pd(upper ? _mm512_unpackhi_ps(x, y) : _mm512_unpacklo_ps(x, y));
        };
        const __m512d r0 = row(0), r1 = row(1), r2 = row(2), r3 = row(3);
        const __m512d lo01 = pairs(r0, r1, false), lo23 = pairs(r2, r3, false);
        const __m512d hi01 = pairs(r0, r1, true), hi23 = pairs(r2, r3, true);
        return {
            T(_mm512_castpd_ps(_mm512_unpacklo_pd(lo01, lo23))), T(_mm512_castpd_ps(_mm512_unpackhi_pd(lo01, lo23))),
            T(_mm512_castpd_ps(_mm512_unpacklo_pd(hi01, hi23))), T(_mm512_castpd_ps(_mm512_unpackhi_pd(hi01, hi23)))};
    }
#endif
    return {gather<T>(p, index), gather<T>(p + 1, index), gather<T>(p + 2, index), gather<T>(p + 3, index)};
}

/// gather() where neighbouring lanes often agree, as neighbouring rays do on what they hit: one load if all do.
template <class T, class S, class I>
[[gnu::always_inline]] inline T gather_coherent(const S* p, const I& index) {
    if constexpr (!is_lane<T>)
        return p[index];
    else {
        const auto first = lane(index, 0);
        return all(index == I(first)) ? T(p[first]) : gather<T>(p, index);
    }
}

/// p[index[i]] = v[i] for the lanes of the mask, in lane order. Indices must be distinct.
template <class T, class I>
[[gnu::always_inline]] inline void scatter(const MaskOf<T>& m, const T& v, ScalarOf<T>* p, const I& index) {
    for (int i = 0; i < width_of<T>; ++i)
        if (lane_bit(m, i)) p[lane(index, i)] = lane(v, i);
}

/// Writes the masked lanes next to each other from p on. May write (rubbish) up to p + width - 1.
template <class T>
[[gnu::always_inline]] inline void compress_store(const MaskOf<T>& m, const T& v, ScalarOf<T>* p) {
#if defined(__AVX512F__)
    using S = ScalarOf<T>;
    if constexpr (width_of<T> == 16 && sizeof(S) == 4) {
        const auto bits = static_cast<__mmask16>(stdx::__data(m));
        if constexpr (std::is_same_v<S, float>)
            _mm512_storeu_ps(p, _mm512_maskz_compress_ps(bits, static_cast<__m512>(v)));
        else
            _mm512_storeu_si512(p, _mm512_maskz_compress_epi32(bits, static_cast<__m512i>(v)));
        return;
    }
    if constexpr (width_of<T> == 8 && sizeof(S) == 8) {
        _mm512_storeu_pd(p, _mm512_maskz_compress_pd(static_cast<__mmask8>(stdx::__data(m)), static_cast<__m512d>(v)));
        return;
    }
#endif
    int n = 0;
    for (int i = 0; i < width_of<T>; ++i)
        if (lane_bit(m, i)) p[n++] = lane(v, i);
}

}  // namespace drt
