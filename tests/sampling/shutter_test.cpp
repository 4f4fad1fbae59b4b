#include "drt/sampling/shutter.h"

#include <gtest/gtest.h>

#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

/// The CDF of the trapezoid at t.
double trapezoid_cdf(double t, double ks) {
    const double ramp = ks / 2, area = 1 - ramp;
    if (t < ramp) return t * t / (2 * ramp) / area;
    if (t > 1 - ramp) return 1 - (1 - t) * (1 - t) / (2 * ramp) / area;
    return (t - ramp / 2) / area;
}

TEST(Shutter, InvertsTheTrapezoid) {
    for (const double ks : {0.0, 1e-6, 0.2, 0.7, 1.0}) {
        double last = -1;
        for (int i = 0; i < 10000; ++i) {
            const double u = i / 10000.0, t = shutter_time(u, ks);
            EXPECT_NEAR(trapezoid_cdf(t, ks), u, 1e-14);
            ASSERT_GT(t, last);
            last = t;
            EXPECT_NEAR(shutter_time(float(u), float(ks)), t, 1e-6);
        }
        EXPECT_LE(last, 1);
        EXPECT_LE(shutter_time(1 - 0x1p-24f, float(ks)), 1.0f);
        EXPECT_EQ(shutter_time(0.0f, float(ks)), 0.0f);
    }
}

TEST(Shutter, RatioZeroIsUniformAndOneATriangle) {
    for (int i = 0; i < 100; ++i) {
        const double u = i / 100.0;
        EXPECT_EQ(shutter_time(u, 0.0), u);
        EXPECT_NEAR(shutter_time(u, 1.0), u < 0.5 ? std::sqrt(u / 2) : 1 - std::sqrt((1 - u) / 2), 1e-15);
    }
}

TEST(Shutter, PdfIsTheDerivativeOfTheCdf) {
    for (const double ks : {0.0, 0.3, 1.0})
        for (const double t : {0.05, 0.1, 0.4, 0.6, 0.93})
            EXPECT_NEAR(shutter_pdf(t, ks), (trapezoid_cdf(t + 1e-6, ks) - trapezoid_cdf(t - 1e-6, ks)) / 2e-6, 1e-6);
}

TEST(Shutter, MovingEdgeCoverage) {
    // S2: an edge that crosses 32 pixels covers pixels 8, 16, 24 for 3/4, 1/2, 1/4 of a box exposure. Stratified: the
    // error of n samples is at most 1/n, where random ones have sqrt(p (1 - p) / n) = 0.03.
    constexpr int n = 256;
    for (const double pixel : {8.0, 16.0, 24.0}) {
        int covered = 0;
        for (std::uint32_t i = 0; i < n; ++i)
            covered +=
                32 * shutter_time(sample_1d(SamplerKind::sobol, SampleSet<double>{11u, i}, dim(PathDim::time)), 0.0) >
                pixel;
        EXPECT_NEAR(covered / double(n), 1 - pixel / 32, 1.0 / n);
    }
}

TEST(Shutter, LanesAgreeWithScalars) {
    using L = Lane<float, 8>;
    const L u([](auto i) { return (float(int(i)) + 0.5f) / 8; });
    const L t = shutter_time(u, L(0.4f));
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(lane(t, i), shutter_time(lane(u, i), 0.4f), 1e-7);
}

}  // namespace
}  // namespace drt
