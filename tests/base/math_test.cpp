#include "drt/base/math.h"

#include <gtest/gtest.h>

#include <random>

namespace drt {
namespace {

constexpr double ulp = 0x1p-24;  // relative, of a float
using L16 = Lane<float, 16>;

/// The largest relative error of `f` against `truth` over x in [lo, hi], evaluated in lanes; also checks that scalars
/// agree with lanes, to `scalar_ulps`.
template <class F, class G>
double worst(double lo, double hi, F f, G truth, bool logarithmic = false, double scalar_ulps = 4) {
    std::mt19937 rng(7);
    std::uniform_real_distribution<double> unit(logarithmic ? std::log(lo) : lo, logarithmic ? std::log(hi) : hi);
    double largest = 0;
    for (int k = 0; k < 20000; ++k) {
        const L16 x([&](auto) { return float(logarithmic ? std::exp(unit(rng)) : unit(rng)); });
        const L16 y = f(x);
        for (int i = 0; i < 16; ++i) {
            const double t = truth(double(lane(x, i)));
            largest = std::max(largest, std::abs(lane(y, i) / t - 1));
        }
        EXPECT_NEAR(lane(y, 0), f(lane(x, 0)), scalar_ulps * ulp * std::abs(lane(y, 0)));
    }
    return largest / ulp;
}

TEST(Math, SinCosOfTurns) {
    double worst_float = 0, worst_double = 0;
    for (int i = -40000; i < 40000; ++i) {
        const float u = float(i) / 13337.0f;
        const double v = i / 13337.0;
        const auto [s, c] = sincos_2pi(u);
        const auto [sd, cd] = sincos_2pi(v);
        const long double a = 2 * pi<long double> * u, b = 2 * pi<long double> * v;
        worst_float = std::max({worst_float, double(std::abs(s - std::sin(a))), double(std::abs(c - std::cos(a)))});
        worst_double = std::max({worst_double, double(std::abs(sd - std::sin(b))), double(std::abs(cd - std::cos(b)))});
    }
    EXPECT_LT(worst_float, 2e-7);
    EXPECT_LT(worst_double, 4e-16);
    EXPECT_EQ(sincos_2pi(0.0f), (std::pair{0.0f, 1.0f}));
    EXPECT_EQ(sincos_2pi(0.25f).second, 0.0f);
    EXPECT_EQ(sincos_2pi(0.5f).first, 0.0f);
    using LD = Lane<double, 8>;
    EXPECT_NEAR(lane(sincos_2pi(LD(0.3)).first, 5), std::sin(0.6 * pi<double>), 4e-16);
}

TEST(Math, Exp) {
    EXPECT_LT(worst(
                  -87, 88.7, [](auto x) { return fast_exp(x); }, [](double x) { return std::exp(x); }),
              1.5);
    EXPECT_EQ(fast_exp(0.0f), 1.0f);
    EXPECT_EQ(fast_exp(-1000.0f), 0.0f);
    EXPECT_EQ(fast_exp(1000.0f), std::numeric_limits<float>::infinity());
    EXPECT_NEAR(fast_exp(-100.0f) / std::exp(-100.0), 1, 0.02);  // subnormal
}

TEST(Math, Expm1) {
    const auto f = [](auto x) { return fast_expm1(x); };
    const auto truth = [](double x) { return std::expm1(x); };
    EXPECT_LT(worst(1e-9, 10, f, truth, true), 3);
    EXPECT_LT(worst(-10, -1e-4, f, truth), 3);
}

TEST(Math, Log) {
    const auto f = [](auto x) { return fast_log(x); };
    const auto truth = [](double x) { return std::log(x); };
    EXPECT_LT(worst(1e-37, 1e38, f, truth, true), 2);
    EXPECT_LT(worst(0.5, 0.999, f, truth), 2);
    EXPECT_LT(worst(1.001, 2, f, truth), 2);
    EXPECT_EQ(fast_log(1.0f), 0.0f);
    EXPECT_EQ(fast_log(0.0f), -std::numeric_limits<float>::infinity());
    EXPECT_EQ(fast_log(std::numeric_limits<float>::infinity()), std::numeric_limits<float>::infinity());
    EXPECT_TRUE(std::isnan(fast_log(-1.0f)));
}

TEST(Math, Log1p) {
    const auto f = [](auto x) { return fast_log1p(x); };
    const auto truth = [](double x) { return std::log1p(x); };
    EXPECT_LT(worst(1e-20, 1e6, f, truth, true), 3);
    EXPECT_LT(worst(-0.999, -1e-5, f, truth), 4);
}

TEST(Math, Pow) {
    for (const double e : {0.5, 2.2, 5.0, -3.0}) {
        // Scalars and lanes may err either way: which of them is fused multiply-adds depends on the machine.
        const double bound = 2 + 2 * std::abs(e) * std::log(4.0);
        EXPECT_LT(worst(
                      0.25, 4.0, [&](auto x) { return fast_pow(x, decltype(x)(float(e))); },
                      [&](double x) { return std::pow(x, double(float(e))); }, false, 2 * bound),
                  bound);
    }
    EXPECT_EQ(fast_pow(0.0f, 0.0f), 1.0f);
    EXPECT_EQ(fast_pow(0.0f, 3.0f), 0.0f);
}

TEST(Math, HighlightIsExactForHugeExponents) {
    for (const double alpha : {0.0, 1.0, 20.0, 1e4, 1e7, 1e9}) {
        // Where the highlight is above 1e-3: alpha (1 - cos) < 7.
        const double largest = std::min(7 / (alpha + 1), 0.9);
        const double error = worst(
            largest * 1e-6, largest,
            [&](auto w) { return pow_cos(decltype(w)(1.0f - w), w, decltype(w)(float(alpha))); },
            [&](double w) { return std::exp(alpha * std::log1p(-w)); }, true, 30);
        EXPECT_LT(error, 2 + 2 * 16.2) << alpha;
    }
    EXPECT_EQ(pow_cos(-0.1f, 1.1f, 2.0f), 0.0f);
}

TEST(Math, ArcFunctions) {
    EXPECT_LT(worst(
                  -1, 1, [](auto x) { return fast_asin(x); }, [](double x) { return std::asin(x); }),
              5);
    EXPECT_LT(worst(
                  -1, 0.9999, [](auto x) { return fast_acos(x); }, [](double x) { return std::acos(x); }),
              4);
    EXPECT_EQ(fast_acos(1.0f), 0.0f);
    EXPECT_EQ(fast_acos(1.5f), 0.0f);
    EXPECT_EQ(fast_asin(0.0f), 0.0f);
    double largest = 0;
    for (int i = 0; i < 100000; ++i) {
        const double a = (i + 0.5) / 100000 * 2 * pi<double> - pi<double>, r = std::exp(i % 40 - 20.0);
        const float y = float(r * std::sin(a)), x = float(r * std::cos(a));
        largest = std::max(largest, std::abs(fast_atan2(y, x) / std::atan2(double(y), double(x)) - 1));
    }
    EXPECT_LT(largest / ulp, 4);
    EXPECT_EQ(fast_atan2(0.0f, 0.0f), 0.0f);
    EXPECT_NEAR(fast_atan2(0.0f, -1.0f), pi<double>, 1e-6);
}

}  // namespace
}  // namespace drt
