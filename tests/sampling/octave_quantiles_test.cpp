#include "drt/sampling/octave_quantiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace drt {
namespace {

struct Case {
    const char* name;
    std::function<double(double)> density;
    double length;
};

const Case cases[] = {
    {"uniform", [](double) { return 2.0; }, 3},
    {"ends in zero", [](double x) { return 1 - x; }, 1},
    {"ends in zero, flat", [](double x) { return (1 - x) * (1 - x); }, 1},
    {"Gaussian", [](double x) { return std::exp(-0.5 * x * x); }, 9.5},
    {"Gaussian cut at 3 sigma", [](double x) { return std::exp(-0.5 * x * x); }, 3},
};

TEST(OctaveQuantiles, AreTheQuantiles) {
    for (const Case& c : cases) {
        const TailMass tail = tail_mass(c.density, c.length);
        const OctaveQuantiles q = octave_quantiles(tail);
        double worst = 0, worst_tail = 0;
        for (int i = 0; i <= 20000; ++i) {
            const double v = std::pow(2.0, -24.0 * i / 20000);
            const double error =
                std::abs(double(quantile(q, float(v))) - quantile(tail, double(float(v)) * tail.total()));
            (v >= 0x1p-15 ? worst : worst_tail) = std::max(v >= 0x1p-15 ? worst : worst_tail, error / c.length);
        }
        EXPECT_LT(worst, 2e-6) << c.name;
        EXPECT_LT(worst_tail, 0.03) << c.name;
        EXPECT_EQ(quantile(q, 1.0f), 0.0f) << c.name;
        EXPECT_GE(quantile(q, 0.0f), quantile(q, 0x1p-23f)) << c.name;
        EXPECT_LE(quantile(q, 0.0f), float(c.length)) << c.name;
    }
}

TEST(OctaveQuantiles, LanesGiveTheScalars) {
    using L = Lane<float, 16>;
    const OctaveQuantiles q = octave_quantiles(tail_mass(cases[3].density, cases[3].length));
    for (int k = 0; k < 256; ++k) {
        const L v([&](auto i) { return std::pow(2.0f, -float(k * 16 + int(i)) / 160); });
        const L x = quantile(q, v);
        for (int i = 0; i < 16; ++i) EXPECT_NEAR(lane(x, i), quantile(q, lane(v, i)), 1e-5);
    }
}

}  // namespace
}  // namespace drt
