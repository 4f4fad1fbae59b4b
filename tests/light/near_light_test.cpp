// Lights that fill much of the view, and the densities of samples: against solid angles in long double and quadrature.

#include <gtest/gtest.h>

#include "drt/light/light_sample.h"
#include "drt/sampling/sampler.h"
#include "light/random_lights.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::RandomLights;

template <class Real>
class NearLights : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(NearLights, Reals);

struct LongVec {
    long double x, y, z;
};
LongVec unit(const Vec3d& v) {
    const long double l = std::sqrt((long double)v.x * v.x + (long double)v.y * v.y + (long double)v.z * v.z);
    return {v.x / l, v.y / l, v.z / l};
}
long double product(const LongVec& a, const LongVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Van Oosterom and Strackee, from p.
double triangle_solid_angle(const Vec3d& p, const Vec3d& a_, const Vec3d& b_, const Vec3d& c_) {
    const LongVec a = unit(a_ - p), b = unit(b_ - p), c = unit(c_ - p);
    const LongVec n{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
    return double(2 * std::atan2(std::abs(product(a, n)), 1 + product(a, b) + product(b, c) + product(c, a)));
}
double solid_angle(const Vec3d& p, const Vec3d& o, const Vec3d& x, const Vec3d& y) {
    return triangle_solid_angle(p, o, o + x, o + x + y) + triangle_solid_angle(p, o, o + x + y, o + y);
}

struct View {
    const char* name;
    Vec3d corner, x, y;
    Vec3d p;
};
// cross(x, y) points to p.
const View views[] = {
    {"square overhead", {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, {0, 0, 0}},
    {"softbox", {-1, 0.02, -1}, {2, 0, 0}, {0, 0, 2}, {0.1, 0, -0.3}},
    {"ceiling", {-1000, 1, -1000}, {2000, 0, 0}, {0, 0, 2000}, {0, 0, 0}},
    {"ceiling, off its diagonals", {-1000, 1, -1000}, {2000, 0, 0}, {0, 0, 2000}, {3, 0, 10}},
    {"beside a wall", {0, 0, -2}, {0, 4, 0}, {0, 0, 4}, {0.3, -0.5, 0}},
    {"tube", {-5, 0.5, 0}, {10, 0, 0}, {0, 0, 0.02}, {1, 0, 0}},
    {"skewed", {-1, 0.6, -1}, {2, 0.3, 0.5}, {1.5, -0.2, 2}, {0, 0, 0}},
    {"needle-like rhomb", {-2, 0.7, 0}, {2, 0, 0.05}, {2, 0, 0.25}, {0, 0, 0.1}},
};

template <class Real>
RectLightData<Real> light_of(const View& v) {
    return cast<Real>(make_rect_light({Color(1.0f), true, -1}, v.corner, v.x, v.y, false));
}

template <class Real>
Vec2<Real> random_point(std::uint32_t i) {
    const Vec2<float> u = sample_2d(SamplerKind::independent, SampleSet<float>{77u, i}, 2);
    return {Real(u.x), Real(u.y)};
}

TYPED_TEST(NearLights, TheDensityIsThatOfTheSolidAngle) {
    for (const View& v : views) {
        const auto l = light_of<TypeParam>(v);
        const auto s = sample_light(l, Vec3<TypeParam>(v.p), {TypeParam(0.3), TypeParam(0.4)});
        EXPECT_TRUE(s.lit) << v.name;
        EXPECT_NEAR(double(s.pdf) * solid_angle(v.p, v.corner, v.x, v.y), 1, 1e-4) << v.name;
    }
}

// In cells of the parallelogram, each expected as often as its solid angle says.
TYPED_TEST(NearLights, DirectionsAreUniform) {
    constexpr int cells = 12, samples = 200000;
    for (const View& v : views) {
        const auto l = light_of<TypeParam>(v);
        const double whole = solid_angle(v.p, v.corner, v.x, v.y);
        std::vector<double> observed(cells * cells), expected(cells * cells);
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                expected[size_t(i * cells + j)] =
                    samples / whole *
                    solid_angle(v.p, v.corner + v.x * (double(i) / cells) + v.y * (double(j) / cells),
                                v.x * (1.0 / cells), v.y * (1.0 / cells));
        const Vec3d n = normalize(cross(v.x, v.y)), across_x = cross(v.y, n), across_y = cross(v.x, n);
        for (std::uint32_t k = 0; k < samples; ++k) {
            const auto s = sample_light(l, Vec3<TypeParam>(v.p), random_point<TypeParam>(k));
            const Vec3d wi(s.wi);
            const Vec3d q = v.p + wi * (dot(v.corner - v.p, n) / dot(wi, n)) - v.corner;
            const double a = dot(q, across_x) / dot(v.x, across_x), b = dot(q, across_y) / dot(v.y, across_y);
            ASSERT_NEAR(double(s.distance), length(q + v.corner - v.p), 1e-3 * double(s.distance)) << v.name;
            const int i = std::clamp(int(a * cells), 0, cells - 1), j = std::clamp(int(b * cells), 0, cells - 1);
            observed[size_t(i * cells + j)] += 1;
        }
        EXPECT_GT(test::chi2_p_value(observed, expected), test::sidak(0.01, 2 * int(std::size(views)))) << v.name;
    }
}

// The irradiance over pi of a light that fills nearly all of the sky, by few samples.
TYPED_TEST(NearLights, CeilingsAreRightWithFewSamples) {
    for (const auto& [view, expected] : {std::pair{views[1], 0.9998}, {views[2], 1 - 5e-7}}) {
        const auto l = light_of<TypeParam>(view);
        double sum = 0;
        constexpr int grid = 200;
        for (int i = 0; i < grid * grid; ++i) {
            const auto s = sample_light(l, Vec3<TypeParam>(view.p),
                                        {TypeParam((i / grid + 0.5) / grid), TypeParam((i % grid + 0.5) / grid)});
            sum += double(intensity(s).r) * double(s.wi.y);
        }
        EXPECT_NEAR(sum / (grid * grid), expected, 5e-4) << view.name;
    }
}

// ---- densities of all kinds ----------------------------------------------------------------------------------------

TYPED_TEST(NearLights, SamplesHaveTheDensityThatIsStatedForTheirDirection) {
    RandomLights r(3);
    LightTable<double> lights;
    for (int i = 0; i < 300; ++i) r.add_any(lights, 2, 3, 1);
    for (auto& l : lights.spheres) l.body = 1;  // visible: they shine inwards, too
    const LightTable<TypeParam> t = cast<TypeParam>(std::move(lights));
    const auto check = [&](const auto& l) {
        const Vec3<TypeParam> p(r.in_box(3));
        const auto s = sample_light(l, p, {TypeParam(r.uniform(0, 1)), TypeParam(r.uniform(0, 1))});
        if (!s.lit) return;
        const float pdf = light_pdf(l, p, s.wi, s.distance);
        EXPECT_NEAR(pdf / s.pdf, s.is_delta ? 0 : 1, 2e-3);
    };
    for (int k = 0; k < 100; ++k) {
        for (const auto& l : t.points) check(l);
        for (const auto& l : t.rects) check(l);
        for (const auto& l : t.spheres) check(l);
    }
}

// The integral of the density over the rectangle, near and far and on both sides of where the method changes.
TYPED_TEST(NearLights, DensitiesIntegrateToOne) {
    for (const View& v : views) {
        for (const double away : {0.01, 0.3, 1.0, 3.0}) {
            const Vec3d n = normalize(cross(v.x, v.y));
            const Vec3d p = v.p - n * (-away * length(v.x));
            const auto l = light_of<TypeParam>(v);
            constexpr int grid = 400;
            double sum = 0, last = 0;
            for (int refine = 1; refine <= 2; ++refine) {
                last = sum;
                sum = 0;
                const int m = grid * refine;
                for (int i = 0; i < m * m; ++i) {
                    const Vec3d q = v.corner + v.x * ((i / m + 0.5) / m) + v.y * ((i % m + 0.5) / m);
                    const double d = length(q - p);
                    const Vec3d wi = (q - p) * (1 / d);
                    const double pdf = light_pdf(l, Vec3<TypeParam>(p), Vec3<TypeParam>(wi), TypeParam(d));
                    sum += pdf * std::abs(dot(wi, n)) / (d * d) * length(cross(v.x, v.y)) / (double(m) * m);
                }
            }
            if (std::abs(sum - last) > 1e-4) continue;  // the quadrature is too coarse for this one
            EXPECT_NEAR(sum, 1, 1e-3) << v.name << " from " << away;
        }
    }
}

TYPED_TEST(NearLights, VisibleSpheresLightTheirInsideEvenly) {
    SphereLightData<TypeParam> l;
    l.color = Color(2.0f);
    l.inverse_square = true;
    l.center = {1, 2, 3};
    l.radius = 2;
    for (const bool radial : {false, true}) {
        l.radial = radial;
        l.body = 5;
        for (const double d : {0.0, 0.5, 1.99}) {
            const Vec3d p{1, 2 + d, 3}, n = normalize(Vec3d{1, 2, -1});
            double sum = 0;
            constexpr int grid = 300;
            for (int i = 0; i < grid * grid; ++i) {
                const auto s = sample_light(l, Vec3<TypeParam>(p),
                                            {TypeParam((i / grid + 0.5) / grid), TypeParam((i % grid + 0.5) / grid)});
                ASSERT_TRUE(s.lit);
                EXPECT_NEAR(length(p + Vec3d(s.wi) * double(s.distance) - Vec3d{1, 2, 3}), 2, 1e-5);
                sum += double(intensity(s).r) * std::max(0.0, dot(Vec3d(s.wi), n));
            }
            EXPECT_NEAR(sum / (grid * grid), 2, 1e-3);  // E = pi L
        }
        l.body = -1;
        EXPECT_FALSE(sample_light(l, {1, 2, 3}, {TypeParam(0.3), TypeParam(0.4)}).lit);
    }
}

}  // namespace
}  // namespace drt
