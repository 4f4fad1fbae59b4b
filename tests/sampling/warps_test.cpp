#include "drt/sampling/warps.h"

#include <gtest/gtest.h>

#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::Mean;
using test::turn_of;
using test::uniformity;

template <class T>
Vec2<T> random_point(std::uint32_t i) {
    return sample_2d(SamplerKind::independent, SampleSet<T>{12345u, i}, 0);
}

const double level = test::sidak(0.01, 16);

TEST(Warps, DiscIsUniform) {
    EXPECT_GT(uniformity([](std::uint32_t i) {
                  const Vec2<float> p = uniform_disc(random_point<float>(i));
                  return Vec2d{double(p.x) * p.x + double(p.y) * p.y, turn_of(p.y, p.x)};
              }),
              level);
}

TEST(Warps, DiscIsContinuousAndFillsTheCircle) {
    for (const auto& [u, v] : {std::pair{0.f, 0.5f}, {0.5f, 0.f}, {1.f, 0.5f}, {0.5f, 1.f}, {0.f, 0.f}}) {
        const Vec2<float> p = uniform_disc(Vec2<float>{u, v});
        EXPECT_NEAR(std::hypot(p.x, p.y), 1, 2e-7);
    }
    const Vec2<float> centre = uniform_disc(Vec2<float>{0.5f, 0.5f});
    EXPECT_EQ(centre, (Vec2<float>{0, 0}));
    double largest = 0;
    for (int i = 1; i < 256; ++i)
        for (int k = 1; k < 256; ++k) {
            const Vec2d a = uniform_disc(Vec2d{i / 256.0, k / 256.0});
            const Vec2d b = uniform_disc(Vec2d{(i + 1) / 256.0, k / 256.0});
            const Vec2d c = uniform_disc(Vec2d{i / 256.0, (k + 1) / 256.0});
            largest = std::max({largest, std::hypot(a.x - b.x, a.y - b.y), std::hypot(a.x - c.x, a.y - c.y)});
        }
    EXPECT_LT(largest, 2.6 / 256);
}

TEST(Warps, RadialDiscHasUniformRadius) {
    EXPECT_GT(uniformity([](std::uint32_t i) {
                  const Vec2<float> p = radial_disc(random_point<float>(i));
                  return Vec2d{std::sqrt(double(p.x) * p.x + double(p.y) * p.y), turn_of(p.y, p.x)};
              }),
              level);
}

TEST(Warps, TriangleIsUniform) {
    // (1 - b0)^2 with b0 = 1 - x - y, and y / (x + y), are uniform for a uniform point.
    EXPECT_GT(uniformity([](std::uint32_t i) {
                  const Vec2<float> p = uniform_triangle(random_point<float>(i));
                  const double s = double(p.x) + p.y;
                  return Vec2d{s * s, s > 0 ? p.y / s : 0.0};
              }),
              level);
}

TEST(Warps, ConeIsUniform) {
    for (const float sin_max : {1.0f, 0.5f, 1e-3f, 1e-7f}) {
        const double cap = one_minus_cos_from_sin(double(sin_max));
        EXPECT_GT(uniformity([&](std::uint32_t i) {
                      const auto s = uniform_cone(random_point<float>(i), sin_max);
                      return Vec2d{s.one_minus_cos / cap, turn_of(s.direction.y, s.direction.x)};
                  }),
                  level)
            << sin_max;
    }
}

TEST(Warps, ConeIsExactForTinyLights) {
    // 1 - cos in float has 7 % error at r/d = 1e-3 and 100 % at 1e-4; s^2 / (1 + c) has none.
    for (const double s : {1.0, 0.3, 1e-3, 1e-4, 1e-7}) {
        const double exact = 2 * pi<double> * s * s / (1 + std::sqrt(1 - s * s));
        EXPECT_NEAR(cone_solid_angle(float(s)) / exact, 1, 1e-6) << s;
    }
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const auto a = uniform_cone(random_point<float>(i), 0.7f);
        EXPECT_NEAR(length(a.direction), 1, 3e-7);
        const auto b = uniform_cone(random_point<float>(i), 1e-5f);
        const double sin2 = double(b.direction.x) * b.direction.x + double(b.direction.y) * b.direction.y;
        EXPECT_NEAR(sin2 / (2.0 * b.one_minus_cos), 1, 1e-6);
    }
}

TEST(Warps, PowerCosineHasItsMomentsAtEveryExponent) {
    // M1: E[cos] = (n + 1) / (n + 2), that is E[1 - cos] = 1 / (n + 2); E[sin^2] = 2 / (n + 3). Four sigma.
    for (const float n : {0.0f, 1.0f, 20.0f, 1e4f, 1e7f, 1e9f}) {
        Mean deficit, sin2;
        for (std::uint32_t i = 0; i < 1 << 17; ++i) {
            const auto s = power_cosine(random_point<float>(i), n);
            deficit.add(s.one_minus_cos);
            sin2.add(double(s.direction.x) * s.direction.x + double(s.direction.y) * s.direction.y);
        }
        EXPECT_NEAR(deficit.mean() * (n + 2.0), 1, 4 * deficit.error() * (n + 2.0) + 1e-6) << n;
        EXPECT_NEAR(sin2.mean() * (n + 3.0) / 2, 1, 4 * sin2.error() * (n + 3.0) / 2 + 1e-6) << n;
    }
}

TEST(Warps, PowerCosineMatchesItsPdf) {
    for (const float n : {0.0f, 1.0f, 50.0f, 1e6f}) {
        // The CDF 1 - (1 - w)^(n + 1) of w = 1 - cos must be uniform.
        EXPECT_GT(uniformity([&](std::uint32_t i) {
                      const auto s = power_cosine(random_point<float>(i), n);
                      const double cdf = -std::expm1((n + 1.0) * std::log1p(-double(s.one_minus_cos)));
                      return Vec2d{cdf, turn_of(s.direction.y, s.direction.x)};
                  }),
                  level)
            << n;
        const double w = 0.3 / (n + 1);
        EXPECT_NEAR(power_cosine_pdf(float(w), n) / ((n + 1) / (2 * pi<double>)*std::pow(1 - w, double(n))), 1, 2e-6);
    }
}

TEST(Warps, LanesAgreeWithScalars) {
    using L = Lane<float, 16>;
    for (std::uint32_t first = 0; first < 1024; first += 16) {
        const Vec2<L> u =
            sample_2d(SamplerKind::sobol,
                      SampleSet<L>{Rebind<L, std::uint32_t>(9u),
                                   Rebind<L, std::uint32_t>([&](auto i) { return first + std::uint32_t(i); })},
                      0);
        const Vec2<L> disc = uniform_disc(u);
        const auto cone = uniform_cone(u, L(0.3f));
        const auto lobe = power_cosine(u, L(100.0f));
        for (int i = 0; i < 16; ++i) {
            const Vec2<float> v{lane(u.x, i), lane(u.y, i)};
            EXPECT_NEAR(lane(disc.x, i), uniform_disc(v).x, 1e-7);
            EXPECT_NEAR(lane(disc.y, i), uniform_disc(v).y, 1e-7);
            EXPECT_NEAR(lane(cone.direction.x, i), uniform_cone(v, 0.3f).direction.x, 1e-7);
            EXPECT_NEAR(lane(lobe.one_minus_cos, i), power_cosine(v, 100.0f).one_minus_cos, 1e-6);
        }
    }
}

}  // namespace
}  // namespace drt
