// Samplers against their densities: a million samples of each in 80 x 160 bins (those of warps.h: warps_test.cpp; of
// lights: tests/light). The levels are such that a right library fails one of this file's tests once in a hundred
// seeds; the seeds are fixed.

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "drt/sampling/distribution.h"
#include "drt/sampling/filter.h"
#include "drt/sampling/lobe.h"
#include "drt/sampling/sampler.h"
#include "drt/sampling/shutter.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::turn_of;
using test::uniformity;

const double level = test::sidak(0.01, 18);

Vec2<float> random_point(std::uint32_t i) { return sample_2d(SamplerKind::independent, SampleSet<float>{2024u, i}, 5); }

/// The CDF of a density on [a, b], by the midpoint rule.
class Cdf {
public:
    Cdf(const std::function<double(double)>& density, double a, double b) : a_(a), scale_(cells / (b - a)) {
        for (int i = 0; i < cells; ++i) sums_[size_t(i) + 1] = sums_[size_t(i)] + density(a + (i + 0.5) / scale_);
    }
    double operator()(double x) const {
        const double at = std::clamp((x - a_) * scale_, 0.0, double(cells));
        const auto i = std::min(size_t(at), size_t(cells - 1));
        return (sums_[i] + (at - double(i)) * (sums_[i + 1] - sums_[i])) / sums_.back();
    }

private:
    static constexpr int cells = 200000;
    double a_, scale_;
    std::vector<double> sums_ = std::vector<double>(cells + 1);
};

TEST(Chi2, RandomPoints) { EXPECT_GT(uniformity(random_point), level); }

TEST(Chi2, PixelFilters) {
    const FilterSpec specs[] = {{FilterKind::box, 0.5, 0},        {FilterKind::triangle, 1, 0},
                                {FilterKind::gaussian, 1.5, 0.5}, {FilterKind::gaussian, 0.5, 1 / 3.0},
                                {FilterKind::mitchell, 2, 0},     {FilterKind::blackman_harris, 1.5, 0}};
    for (const FilterSpec& spec : specs) {
        const FilterTable filter = make_filter(spec);
        const Cdf cdf([&](double x) { return std::abs(filter_value(spec, x)); }, -spec.radius, spec.radius);
        EXPECT_GT(uniformity([&](std::uint32_t i) {
                      const Vec2<float> offset = sample_filter(filter, random_point(i)).offset;
                      return Vec2d{cdf(offset.x), cdf(offset.y)};
                  }),
                  level)
            << int(spec.kind);
    }
}

TEST(Chi2, GlossyLobes) {
    const Vec3<float> axis = normalize(Vec3<float>{0.3f, -0.5f, 0.8f});
    const Frame<float> frame = frame_around(axis);
    for (const double sigma : {0.01, 0.3, 1.5, 100.0}) {
        LobeTables tables;
        const int lobe = add_lobe(tables, sigma);
        const Cdf cdf([&](double t) { return std::exp(-t * t / (2 * sigma * sigma)) * std::cos(t); }, 0,
                      std::min(pi<double> / 2, 8 * sigma));
        EXPECT_GT(uniformity([&](std::uint32_t i) {
                      const Vec2<float> u = random_point(i);
                      const Vec3<float> d = lobe_direction(frame, lobe_theta(tables, lobe, u.x), u.y);
                      const double x = dot(d, frame.x), y = dot(d, frame.y), z = dot(d, frame.z);
                      return Vec2d{cdf(fast_atan2(float(std::sqrt(x * x + y * y)), float(z))), turn_of(y, x)};
                  }),
                  level)
            << sigma;
    }
}

/// Two moments of one exposure.
TEST(Chi2, ShutterTimes) {
    for (const float ratio : {0.0f, 0.2f, 0.8f, 1.0f}) {
        const Cdf cdf(
            [&](double t) {
                const double edge = std::min(t, 1 - t), ramp = double(ratio) / 2;
                return edge < ramp ? edge / ramp : 1;
            },
            0, 1);
        EXPECT_GT(uniformity([&](std::uint32_t i) {
                      const Vec2<float> u = random_point(i);
                      return Vec2d{cdf(shutter_time(u.x, ratio)), cdf(shutter_time(u.y, ratio))};
                  }),
                  level)
            << ratio;
    }
}

TEST(Chi2, ChoicesByWeight) {
    constexpr int things = 80 * 160, samples = 1000000;
    std::mt19937 random(7);
    std::vector<double> weights(things), counts(things), expected;
    for (double& w : weights) w = std::exp2(-double(random() % 1000) / 100);
    weights[17] = 0;
    const Distribution d = make_distribution(weights);
    double sum = 0;
    for (const double w : weights) sum += w;
    for (const double w : weights) expected.push_back(samples * w / sum);
    for (std::uint32_t i = 0; i < samples; ++i) counts[size_t(choose<float>(d, random_point(i).x).index)] += 1;
    EXPECT_GT(test::chi2_p_value(counts, expected), level);
}

}  // namespace
}  // namespace drt
