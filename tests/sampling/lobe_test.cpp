#include "drt/sampling/lobe.h"

#include <gtest/gtest.h>

#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

/// The truth, slowly: Simpson's rule.
double simpson(const std::function<double(double)>& f, double a, double b, int n = 4000) {
    double sum = f(a) + f(b);
    for (int i = 1; i < n; ++i) sum += f(a + (b - a) * i / n) * (i % 2 ? 4 : 2);
    return sum * (b - a) / (3.0 * n);
}

struct SlowLobe {
    double sigma, end, total;
    explicit SlowLobe(double s) : sigma(s), end(std::min(pi<double> / 2, 12 * s)), total(simpson(density(), 0, end)) {}
    std::function<double(double)> density() const {
        return [s = sigma](double t) { return std::exp(-t * t / (2 * s * s)) * std::cos(t); };
    }
    double beyond(double theta) const {
        return simpson(density(), theta, std::max(theta, std::min(end, theta + 8 * sigma))) / total;
    }
};

TEST(Lobe, InverseCdfIsExactFromPointsToTheFullHemisphere) {
    for (const double sigma : {1e-6, 1e-3, 0.05, 0.5, 1.5, 3.0, 100.0}) {
        LobeTables tables;
        const int lobe = add_lobe(tables, sigma);
        const SlowLobe truth(sigma);
        EXPECT_NEAR(tables.integral[0] / truth.total, 1, 1e-11);
        double last = -1;
        for (int i = 0; i < 400; ++i) {
            // u from 1e-6 up, and 1 - u from 6e-8 up, on the sampler's grid of 2^-24
            const double raw = i < 200 ? std::pow(10.0, -6.1 + i * 0.03) : 1 - std::pow(2.0, -(i - 200) * 0.12);
            const float u = float(std::round(raw * 0x1p24) * 0x1p-24);
            if (u <= 0 || u >= 1) continue;
            const float theta = lobe_theta(tables, lobe, u);
            const double v = truth.beyond(theta), exact = 1 - double(u);
            const double rounding = truth.density()(theta) / truth.total * theta * 0x1p-23;
            EXPECT_NEAR(v, exact, 1e-6 * std::min(exact, double(u) + 1e-6) + rounding)
                << "sigma " << sigma << ", u " << u;
        }
        for (int i = 0; i < 1 << 16; ++i) {
            const double theta = lobe_theta(tables, lobe, float(i) * 0x1p-16f);
            ASSERT_GT(theta, last);  // strictly monotone: strata stay strata
            last = theta;
        }
        EXPECT_EQ(lobe_theta(tables, lobe, 0.0f), 0.0f);
        EXPECT_LT(lobe_theta(tables, lobe, 1 - 0x1p-24f), float(pi<double> / 2));
        EXPECT_LT(lobe_theta(tables, lobe, 1 - 0x1p-32), pi<double> / 2);
    }
}

TEST(Lobe, SamplesFollowThePdf) {
    constexpr int n = 1 << 18, bins = 100;
    for (const double sigma : {0.01, 0.3, 1.5, 100.0}) {
        LobeTables tables;
        const int lobe = add_lobe(tables, sigma);
        const double end = std::min(pi<double> / 2, 5 * sigma);
        std::vector<double> counts(bins + 1), expected(bins + 1);
        double rest = 1;
        for (int b = 0; b < bins; ++b) {
            const auto pdf = [&](double t) { return lobe_pdf_theta(tables, lobe, t); };
            expected[size_t(b)] = n * simpson(pdf, end * b / bins, end * (b + 1) / bins - 1e-12, 20);
            rest -= expected[size_t(b)] / n;
        }
        expected[bins] = std::max(n * rest, 1e-9);
        test::Mean cosine;
        for (std::uint32_t i = 0; i < n; ++i) {
            const SampleSet<float> set{3u, i};
            const float theta = lobe_theta(tables, lobe, sample_1d(SamplerKind::independent, set, 0));
            counts[std::min(size_t(theta / end * bins), size_t(bins))] += 1;
            cosine.add(std::cos(double(theta)));
        }
        EXPECT_GT(test::chi2_p_value(counts, expected), test::sidak(0.01, 4)) << sigma;
        const SlowLobe truth(sigma);
        const double mean =
            simpson([&](double t) { return truth.density()(t) * std::cos(t); }, 0, truth.end) / truth.total;
        EXPECT_NEAR(cosine.mean(), mean, 4 * cosine.error());
    }
}

TEST(Lobe, LanesMayUseDifferentTables) {
    using L = Lane<float, 16>;
    using I = Rebind<L, std::int32_t>;
    LobeTables tables;
    const int sharp = add_lobe(tables, 0), narrow = add_lobe(tables, 0.1), wide = add_lobe(tables, 2.0);
    EXPECT_EQ(add_lobe(tables, 0.1), narrow);
    const I lobe([&](auto i) { return i % 3 == 0 ? sharp : i % 3 == 1 ? narrow : wide; });
    for (int k = 0; k < 100; ++k) {
        const L u([&](auto i) { return float(k * 16 + int(i)) / 2048; });
        const L theta = lobe_theta(tables, lobe, u);
        for (int i = 0; i < 16; ++i) {
            EXPECT_NEAR(lane(theta, i), lobe_theta(tables, lane(lobe, i), lane(u, i)), 1e-6f * lane(theta, i));
            EXPECT_NEAR(lane(theta, i), lobe_theta(tables, lane(lobe, i), double(lane(u, i))), 1e-6 * lane(theta, i));
            if (i % 3 == 0) {
                EXPECT_EQ(lane(theta, i), 0.0f);
            }
        }
    }
}

TEST(Lobe, DirectionLeansByThetaTowardsTheAzimuth) {
    const Vec3d d = normalize(Vec3d{0.3, -0.5, 0.8});
    const Frame<double> frame = frame_around(d);
    for (const double theta : {0.0, 1e-6, 0.3, 1.5})
        for (const double turns : {0.0, 0.2, 0.7}) {
            const Vec3d w = lobe_direction(frame, theta, turns);
            const double phi = 2 * pi<double> * turns;
            const Vec3d model = normalize(d + (frame.x * std::cos(phi) + frame.y * std::sin(phi)) * std::tan(theta));
            EXPECT_NEAR(length(w - model), 0, 1e-14);
        }
}

}  // namespace
}  // namespace drt
