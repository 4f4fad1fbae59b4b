#include "drt/sampling/filter.h"

#include <gtest/gtest.h>

#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using Kind = FilterKind;

const FilterSpec specs[] = {{Kind::box, 0.5, 0},        {Kind::triangle, 1, 0},
                            {Kind::gaussian, 1.5, 0.5}, {Kind::gaussian, 0.5, 1 / 3.0},
                            {Kind::gaussian, 50, 0.4},  {Kind::blackman_harris, 1.5, 0},
                            {Kind::mitchell, 2, 0},     {Kind::mitchell, 3, 0}};

double integral(const FilterSpec& s, double a, double b, int n = 2000) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += filter_value(s, a + (b - a) * (i + 0.5) / n);
    return sum * (b - a) / n;
}

TEST(Filter, GaussianMass) {
    // P7: erf(3 / sqrt(2)) for sigma 0.5 cut off at 1.5
    const FilterTable f = make_filter({Kind::gaussian, 1.5, 0.5});
    EXPECT_NEAR(f.integral, 0.997300203936740, 1e-12);
    EXPECT_NEAR(make_filter({Kind::mitchell, 2, 0}).integral, 1, 1e-8);
    EXPECT_NEAR(make_filter({Kind::blackman_harris, 1.5, 0}).integral, 2 * 1.5 * 0.35875, 1e-9);
}

TEST(Filter, SamplesFollowTheFilterWithItsSign) {
    // Counts of |f|, and the signed histogram: each bin's weights sum up to f's integral over the bin.
    constexpr int n = 1 << 18, bins = 120;
    for (const FilterSpec& spec : specs) {
        const FilterTable filter = make_filter(spec);
        const double reach = spec.kind == Kind::gaussian ? std::min(spec.radius, 6 * spec.sigma) : spec.radius;
        std::vector<double> counts(bins), expected(bins), weights(bins);
        double sum = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto u = sample_2d(SamplerKind::independent, SampleSet<float>{17u, i}, 3);
            const FilterSample<float> s = sample_filter(filter, u);
            ASSERT_LE(std::abs(s.offset.x), float(spec.radius));
            ASSERT_LE(std::abs(s.offset.y), float(spec.radius));
            const int b = std::clamp(int((s.offset.x / reach + 1) / 2 * bins), 0, bins - 1);
            counts[size_t(b)] += 1;
            weights[size_t(b)] += s.weight;
            sum += s.weight;
        }
        double z2 = 0;
        const double ratio = filter.absolute_integral / filter.integral;
        for (int b = 0; b < bins; ++b) {
            const double lo = reach * (2.0 * b / bins - 1),
                         f = integral(spec, lo, lo + 2 * reach / bins, 200) / filter.integral;
            FilterSpec absolute = spec;
            double mass = 0;
            for (int k = 0; k < 200; ++k)
                mass += std::abs(filter_value(absolute, lo + 2 * reach / bins * (k + 0.5) / 200));
            expected[size_t(b)] = n * mass * (2 * reach / bins / 200) / filter.absolute_integral;
            // Each weight has magnitude at most ratio^2 (the other axis' sign is free).
            const double sigma = ratio * ratio * std::sqrt(expected[size_t(b)] + 1);
            z2 = std::max(z2, std::abs(weights[size_t(b)] - n * f) / sigma);
        }
        EXPECT_GT(test::chi2_p_value(counts, expected), test::sidak(0.01, 8)) << int(spec.kind) << " " << spec.radius;
        EXPECT_LT(z2, 4.5) << int(spec.kind);
        const double negative = ratio * ratio;
        EXPECT_NEAR(sum / n, 1, 5 * std::sqrt(negative * negative - 1) / std::sqrt(n) + 1e-7);
    }
}

TEST(Filter, OffsetsAreMonotoneAndSymmetric) {
    for (const FilterSpec& spec : specs) {
        const FilterTable filter = make_filter(spec);
        float last = -1e9f;
        for (int i = 1; i < 4096; ++i) {
            const float u = float(i) / 4096;
            const float x = sample_filter(filter, Vec2<float>{u, 0.3f}).offset.x;
            ASSERT_GE(x, last) << int(spec.kind) << " at " << u;
            last = x;
            EXPECT_EQ(x, -sample_filter(filter, Vec2<float>{1 - u, 0.3f}).offset.x);
        }
    }
}

TEST(Filter, SobolWeightsSumToOne) {
    for (const FilterSpec& spec : specs) {
        const FilterTable filter = make_filter(spec);
        double sum = 0;
        for (std::uint32_t i = 0; i < 4096; ++i)
            sum += sample_filter(filter, sample_2d(SamplerKind::sobol, SampleSet<float>{5u, i}, 0)).weight;
        // Exact without negative lobes; with them, as good as the net resolves the lobes' borders.
        EXPECT_NEAR(sum / 4096, 1, spec.kind == Kind::mitchell ? 2e-3 : 1e-7);
    }
}

TEST(Filter, PointIsTheCentre) {
    const FilterSample<float> s = sample_filter(make_filter({Kind::point, 1, 1}), Vec2<float>{0.1f, 0.9f});
    EXPECT_EQ(s.offset, (Vec2<float>{0, 0}));
    EXPECT_EQ(s.weight, 1.0f);
}

TEST(Filter, LanesAgreeWithScalars) {
    using L = Lane<float, 16>;
    for (const FilterSpec& spec : specs) {
        const FilterTable filter = make_filter(spec);
        for (int k = 0; k < 64; ++k) {
            const L u([&](auto i) { return (float(k * 16 + int(i)) + 0.37f) / 1024; });
            const FilterSample<L> s = sample_filter(filter, Vec2<L>{u, L(0.2f)});
            for (int i = 0; i < 16; ++i) {
                const FilterSample<float> one = sample_filter(filter, Vec2<float>{lane(u, i), 0.2f});
                EXPECT_NEAR(lane(s.offset.x, i), one.offset.x, 1e-6);
                EXPECT_EQ(lane(s.weight, i), one.weight);
            }
        }
    }
}

}  // namespace
}  // namespace drt
