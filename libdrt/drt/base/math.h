#pragma once
// Elementary functions for scalars and lanes of float and double.
//
// std::experimental::simd computes these lane by lane through libm. The float versions here are branch-free polynomials
// (near-minimax, by Chebyshev interpolation with mpmath; schemes after Moshier's Cephes), the same for scalars and
// lanes. Double lanes call libm per lane, except sincos_2pi: nothing in the hot path needs the others in double.
// Errors are the largest measured by tests/base/math_test.cpp; "ulp" is 2^-24 relative for float.

#include <utility>

#include "drt/base/bits.h"
#include "drt/base/constants.h"

namespace drt {

/// a * b + c, fused where the machine has it: the compiler contracts it.
template <class T>
[[gnu::always_inline]] inline T mul_add(const T& a, const T& b, const T& c) {
    return a * b + c;
}

namespace math_detail {

template <class T, class F>
[[gnu::always_inline]] inline T per_lane(const T& x, F f) {
    if constexpr (!is_lane<T>)
        return f(x);
    else
        return T([&](auto i) { return f(ScalarOf<T>(x[i])); });
}

template <class T, class F>
[[gnu::always_inline]] inline T per_lane(const T& x, const T& y, F f) {
    if constexpr (!is_lane<T>)
        return f(x, y);
    else
        return T([&](auto i) { return f(ScalarOf<T>(x[i]), ScalarOf<T>(y[i])); });
}

template <class T>
inline constexpr bool is_float = std::is_same_v<ScalarOf<T>, float>;

/// Horner's scheme; coefficients from the constant upwards.
template <class T, class... C>
[[gnu::always_inline]] inline T polynomial(const T& x, ScalarOf<T> c0, C... rest) {
    if constexpr (sizeof...(rest) == 0)
        return T(c0);
    else
        return mul_add(x, polynomial(x, rest...), T(c0));
}

/// 2^n for n in [-126, 127].
template <class T>
[[gnu::always_inline]] inline T power_of_two(const Rebind<T, std::int32_t>& n) {
    using I = Rebind<T, std::int32_t>;
    return bits_as<T>(I((n + I(127)) << 23));
}

/// To the nearest integer, |x| < 2^22: adding 1.5 * 2^23 pushes the fraction out. Stays a float.
inline constexpr float round_magic = 12582912.0f;
template <class T>
[[gnu::always_inline]] inline T round_small(const T& x) {
    if constexpr (is_float<T>)
        return (x + T(round_magic)) - T(round_magic);
    else
        return (x + T(6755399441055744.0)) - T(6755399441055744.0);
}

template <class T>
[[gnu::always_inline]] inline T copy_sign(const T& magnitude, const T& sign) {
    return select(sign < T(0), -magnitude, magnitude);
}

}  // namespace math_detail

/// {sin, cos} of 2 pi u, |u| < 2^20; exact zeros at multiples of a quarter. Float: error <= 2e-7; double: <= 4e-16.
template <class T>
[[gnu::always_inline]] inline std::pair<T, T> sincos_2pi(const T& u) {
    using namespace math_detail;
    const T half_turns = round_small(T(u * T(2)));
    const T r = T(2) * u - half_turns;  // exact, in [-1/2, 1/2]
    const T r2 = r * r;
    const T zeros = (T(0.5f) - r) * (T(0.5f) + r);  // factored out of the cosine: relative precision at its zeros
    T s, c;
    if constexpr (is_float<T>) {
        s = r * polynomial(r2, 3.14159264f, -5.167710077f, 2.550077387f, -0.5982904113f, 0.07765591228f);
        c = zeros * polynomial(r2, 3.999999996f, -3.7392081f, 1.277990797f, -0.2287450884f, 0.02416710613f);
    } else {
        s = r * polynomial(r2, 3.14159265358979324, -5.16771278004997003, 2.55016403987734534, -0.599264529320786899,
                           0.0821458866109935574, -0.00737043094370213585, 0.000466302787459327272,
                           -0.0000219152503018513727, 7.94853903737228963e-7, -2.22837121606943407e-8);
        c = zeros * polynomial(r2, 4.0, -3.73920880217871717, 1.27801329695219688, -0.228997887609252975,
                               0.0253309709914488124, -0.00190368150157433966, 0.000103570487775368928,
                               -4.26674038819893073e-6, 1.33915467721537382e-7);
    }
    const T odd = half_turns - T(2) * round_small(T(half_turns * T(0.5f)));  // 0 or +-1: an odd half turn flips both
    const T sign = T(1) - T(2) * (odd * odd);
    return {sign * s, sign * c};
}

/// e^x. Float: 1.5 ulp relative for results down to 2^-126, 0 below -104, +inf above 88.73.
template <class T>
[[gnu::always_inline]] inline T fast_exp(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::exp(v); });
    } else {
        using I = Rebind<T, std::int32_t>;
        const T bounded = clamp(x, T(-110.0f), T(90.0f));
        const T n = round_small(T(bounded * T(1.44269504f)));
        const T r =
            mul_add(n, T(2.12194440e-4f), mul_add(n, T(-0.693359375f), bounded));  // n ln 2 in two parts (Cody, Waite)
        const T p = polynomial(r, 0.5f, 0.1666657338f, 0.04166655011f, 0.008363773874f, 0.001392692661f);
        // Scaled in two steps, so that 2^n may leave the range of normal numbers.
        const I whole = num_cast<I>(n);
        const I half = whole >> 1;
        return (T(1.0f) + (r + r * r * p)) * power_of_two<T>(half) * power_of_two<T>(I(whole - half));
    }
}

/// e^x - 1, exact to the relative error also near 0. Float: 3 ulp.
template <class T>
[[gnu::always_inline]] inline T fast_expm1(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::expm1(v); });
    } else {
        const T p = polynomial(x, 0.5000000122f, 0.166666668f, 0.04166579123f, 0.008333236134f, 0.001398218605f,
                               0.0001994487444f);
        return select(x < T(0.5f) && x > T(-0.5f), T(x + x * x * p), T(fast_exp(x) - T(1.0f)));
    }
}

namespace math_detail {
/// log(1 + f) for f in [sqrt(1/2) - 1, sqrt(2) - 1].
template <class T>
[[gnu::always_inline]] inline T log1p_reduced(const T& f, const T& exponent) {
    const T f2 = f * f;
    const T p = polynomial(f, 0.3333333118f, -0.2499999696f, 0.2000071575f, -0.1666780232f, 0.1424905765f,
                           -0.1242568733f, 0.1168541992f, -0.1147973385f, 0.06971611471f);
    const T tail = mul_add(exponent, T(-2.12194440e-4f), T(f2 * f * p - T(0.5f) * f2));
    return mul_add(exponent, T(0.693359375f), T(f + tail));
}

/// x = m * 2^e, m in [sqrt(1/2), sqrt(2)); x normal and positive.
template <class T>
[[gnu::always_inline]] inline std::pair<T, T> split_exponent(const T& x) {
    using I = Rebind<T, std::int32_t>;
    const I bits = bits_as<I>(x);
    const I e = (bits - I(0x3f3504f3)) >> 23;  // 0x3f3504f3 is sqrt(1/2)
    return {bits_as<T>(I(bits - (e << 23))), num_cast<T>(e)};
}

/// y, or what the logarithm of x is where x is not a normal positive number.
template <class T>
[[gnu::always_inline]] inline T log_in_range(const T& x, T y) {
    using L = std::numeric_limits<float>;
    y = select(x > T(L::max()), x, y);
    y = select(x < T(L::min()), T(-L::infinity()), y);
    return select(x < T(0.0f), T(L::quiet_NaN()), y);
}
}  // namespace math_detail

/// Natural logarithm of x >= 2^-126; -inf at (and below the normal numbers at) 0, NaN for x < 0. Float: 1.5 ulp
/// relative.
template <class T>
[[gnu::always_inline]] inline T fast_log(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::log(v); });
    } else {
        const auto [m, e] = split_exponent(x);
        return log_in_range(x, log1p_reduced(T(m - T(1.0f)), e));
    }
}

/// log(1 + x), x > -1, with the relative error kept near 0. Float: 4 ulp.
template <class T>
[[gnu::always_inline]] inline T fast_log1p(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::log1p(v); });
    } else {
        using I = Rebind<T, std::int32_t>;
        const T u = T(1.0f) + x;
        const T lost = x - (u - T(1.0f));  // what the rounding of u took away
        const auto [m, e] = split_exponent(u);
        // the exponent of a huge u may be 127, for which nothing is lost and 2^-126 does as well
        const T scale = power_of_two<T>(max(I(-num_cast<I>(e)), I(-126)));
        return log_in_range(u, log1p_reduced(T((m - T(1.0f)) + lost * scale), e));
    }
}

/// base^exponent for base >= 0; 0^0 = 1. Float: relative error <= (2 + 2 |exponent log base|) ulp, so 1e-6 or better
/// wherever the result is in [1e-3, 1e3]. Near base 1 the rounding of `base` itself, exponent * 2^-25, dominates: use
/// pow_one_minus.
template <class T>
[[gnu::always_inline]] inline T fast_pow(const T& base, const T& exponent) {
    using namespace math_detail;
    if constexpr (!is_float<T>)
        return per_lane(base, exponent, [](double b, double e) { return std::pow(b, e); });
    else
        return select(exponent == T(0.0f), T(1.0f), fast_exp(T(exponent * fast_log(base))));
}

/// (1 - x)^exponent for x in [0, 1], exponent >= 0: a Phong highlight cos^alpha from x = 1 - cos, where x is computed
/// without cancellation (|r - l|^2 / 2 for unit vectors). Exact in the limit of large exponents: float relative error
/// <= (2 + 2 |log of the result|) ulp for every exponent.
template <class T>
[[gnu::always_inline]] inline T pow_one_minus(const T& x, const T& exponent) {
    return select(exponent == T(0), T(1), fast_exp(T(exponent * fast_log1p(T(-x)))));
}

/// Highlight cos^alpha for unit vectors r and l given as cos = r.l and one_minus_cos = |r - l|^2 / 2; 0 where
/// cos <= 0. Error as pow_one_minus; from cos alone in float it would be alpha * 2^-25, useless beyond alpha ~ 1e4.
template <class T>
[[gnu::always_inline]] inline T pow_cos(const T& cos, const T& one_minus_cos, const T& alpha) {
    return select(cos > T(0), pow_one_minus(min(one_minus_cos, T(1)), alpha), T(0));
}

namespace math_detail {
/// asin for |x| <= 1/2.
template <class T>
[[gnu::always_inline]] inline T asin_reduced(const T& x) {
    const T z = x * x;
    return mul_add(T(x * z),
                   polynomial(z, 0.1666667241f, 0.07498855073f, 0.04500138007f, 0.0265545422f, 0.03808502357f), x);
}
}  // namespace math_detail

/// |x| <= 1 (beyond: as at 1). Float: 5 ulp relative.
template <class T>
[[gnu::always_inline]] inline T fast_asin(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::asin(std::fmin(std::fmax(v, -1.0), 1.0)); });
    } else {
        using std::sqrt;
        const T a = min(select(x < T(0.0f), T(-x), x), T(1.0f));
        const auto large = a > T(0.5f);
        const T r = asin_reduced(select(large, T(sqrt(T(0.5f) - T(0.5f) * a)), a));
        return copy_sign(select(large, T(T(pi<float> / 2) - T(2.0f) * r), r), x);
    }
}

/// |x| <= 1 (beyond: as at 1). Float: 4 ulp relative.
template <class T>
[[gnu::always_inline]] inline T fast_acos(const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(x, [](double v) { return std::acos(std::fmin(std::fmax(v, -1.0), 1.0)); });
    } else {
        using std::sqrt;
        const T a = min(select(x < T(0.0f), T(-x), x), T(1.0f));
        const auto large = a > T(0.5f);
        const T r = asin_reduced(select(large, T(sqrt(T(0.5f) - T(0.5f) * a)), x));
        const T near_pole = select(x < T(0.0f), T(T(pi<float>) - T(2.0f) * r), T(T(2.0f) * r));
        return select(large, near_pole, T(T(pi<float> / 2) - r));
    }
}

/// The angle of (x, y) in [-pi, pi]; 0 at the origin. Float: 3 ulp relative.
template <class T>
[[gnu::always_inline]] inline T fast_atan2(const T& y, const T& x) {
    using namespace math_detail;
    if constexpr (!is_float<T>) {
        return per_lane(y, x, [](double v, double u) { return u == 0 && v == 0 ? 0.0 : std::atan2(v, u); });
    } else {
        const T ax = select(x < T(0.0f), T(-x), x);
        const T ay = select(y < T(0.0f), T(-y), y);
        const auto steep = ay > ax;
        const T large = select(steep, ay, ax);
        const T q = select(large > T(0.0f), T(select(steep, ax, ay) / large), T(0.0f));
        const T z = q * q;
        T a = mul_add(T(q * z),
                      polynomial(z, -0.333333231f, 0.1999868117f, -0.1425704493f, 0.1086575908f, -0.08009681716f,
                                 0.04891432153f, -0.02002674764f, 0.003866738913f),
                      q);
        a = select(steep, T(T(pi<float> / 2) - a), a);
        a = select(x < T(0.0f), T(T(pi<float>) - a), a);
        return copy_sign(a, y);
    }
}

}  // namespace drt
