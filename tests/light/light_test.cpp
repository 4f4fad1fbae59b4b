// What each kind of light sends to a point: sums over a fine grid of samples against closed forms.
//
// A sample is I_l, so the mean of I_l cos(theta) over the light's samples is the irradiance on a surface divided by pi:
// radiance times the form factor.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "drt/light/light_sample.h"
#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

constexpr double inv_pi = 1 / pi<double>;

template <class Real>
RectLightData<Real> rect(const Vec3d& corner, const Vec3d& x, const Vec3d& y, bool two_sided = false) {
    return cast<Real>(make_rect_light({Color(1.0f), true, -1}, corner, x, y, two_sided));
}

template <class Real>
SphereLightData<Real> bulb(const Vec3d& center, double radius, bool radial = false) {
    SphereLightData<Real> l;
    l.color = Color(1.0f);
    l.inverse_square = true;
    l.center = Vec3<Real>(center);
    l.radius = Real(radius);
    l.radial = radial;
    return l;
}

template <class Real>
PointLightData<Real> point(const Vec3d& position) {
    PointLightData<Real> l;
    l.color = Color(1.0f);
    l.inverse_square = true;
    l.position = Vec3<Real>(position);
    return l;
}

/// The mean of I_l max(0, cos) at p with normal n over the midpoints of a grid of the unit square.
template <class Real, template <class> class Kind>
double mean_intensity(const Kind<Real>& light, const Vec3d& p, const Vec3d& n, int grid = 400) {
    double sum = 0;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const Vec2<Real> u{Real((i + 0.5) / grid), Real((j + 0.5) / grid)};
            const LightSample<Real> s = sample_light(light, Vec3<Real>(p), u);
            if (s.lit) sum += double(intensity(s).r) * std::max(0.0, dot(Vec3d(s.wi), n));
        }
    return sum / grid / grid;
}

// Lambert's formula for a polygon seen from the origin, all of it above the horizon.
double form_factor(const std::vector<Vec3d>& polygon, const Vec3d& n) {
    double sum = 0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d a = normalize(polygon[i]), b = normalize(polygon[(i + 1) % polygon.size()]);
        const Vec3d axis = cross(a, b);
        sum += std::atan2(length(axis), dot(a, b)) * dot(normalize(axis), n);
    }
    return std::abs(sum) / (2 * pi<double>);
}

const Vec3d up{0, 0, 1};

template <class Real>
class Lights : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Lights, Reals);

// ---- rectangles
// ------------------------------------------------------------------------------------------------------

TYPED_TEST(Lights, RectanglesShineAsLambertSays) {
    const struct {
        Vec3d center;
        double expected;
    } cases[] = {{{0, 0, 2}, 0.2394564705}, {{2, 2, 2}, 0.0395828637}};
    for (const auto& c : cases) {
        const Vec3d x{2, 0, 0}, y{0, -2, 0};  // cross(x, y) points down
        const Vec3d corner = c.center - (x + y) * 0.5;
        EXPECT_NEAR(form_factor({corner, corner + x, corner + x + y, corner + y}, up), c.expected, 1e-10);
        EXPECT_NEAR(mean_intensity(rect<TypeParam>(corner, x, y), {}, up), c.expected, 1e-5);
        EXPECT_NEAR(mean_intensity(rect<TypeParam>(corner, x, y, true), {}, up), c.expected, 1e-5);
    }
    const Vec3d corner{-1, 0.3, 3}, x{1, 0.5, 0.4}, y{0.2, -1.5, 0.1};  // a skewed parallelogram
    EXPECT_NEAR(mean_intensity(rect<TypeParam>(corner, x, y), {}, up),
                form_factor({corner, corner + x, corner + x + y, corner + y}, up), 1e-5);
}

TYPED_TEST(Lights, RectanglesAreDarkBehindUnlessTwoSided) {
    const Vec3d corner{-1, -1, 2}, x{2, 0, 0}, y{0, 2, 0};  // shines upwards, away from the origin
    const auto one = rect<TypeParam>(corner, x, y), both = rect<TypeParam>(corner, x, y, true);
    const Vec2<TypeParam> u{TypeParam(0.3), TypeParam(0.6)};
    EXPECT_FALSE(sample_light(one, {}, u).lit);
    EXPECT_TRUE(sample_light(both, {}, u).lit);
    EXPECT_NEAR(mean_intensity(both, {}, up), 0.2394564705, 1e-5);
    EXPECT_FALSE(sample_light(both, {5, 0, 2}, u).lit);  // edge-on
    const LightSample<TypeParam> touching = sample_light(both, both.corner + both.edge_x * u.x + both.edge_y * u.y, u);
    EXPECT_FALSE(touching.lit);
}

TYPED_TEST(Lights, RectangleSamplesLieOnTheRectangle) {
    const auto l = rect<TypeParam>({-1, 0.3, 3}, {1, 0.5, 0.4}, {0.2, -1.5, 0.1});
    for (const TypeParam v : {TypeParam(0), TypeParam(0.25), TypeParam(0.99)}) {
        const LightSample<TypeParam> s = sample_light(l, {1, 2, 0}, {v, TypeParam(0.5)});
        const Vec3<TypeParam> q = Vec3<TypeParam>{1, 2, 0} + s.wi * s.distance;
        EXPECT_LE(length(q - (l.corner + l.edge_x * v + l.edge_y * TypeParam(0.5))), TypeParam(2e-6));
    }
}

// ---- spheres
// ---------------------------------------------------------------------------------------------------------

Vec3d tilted(double degrees) { return {std::sin(radians(degrees)), 0, std::cos(radians(degrees))}; }

TYPED_TEST(Lights, SpheresShineAsTheirSolidAngleSays) {
    const auto l = bulb<TypeParam>({0, 0, 2}, 1);
    EXPECT_NEAR(mean_intensity(l, {}, up), 0.25, 1e-5);  // (r / d)^2
    EXPECT_NEAR(mean_intensity(l, {}, tilted(45)), 0.1767766953, 1e-5);
    EXPECT_NEAR(mean_intensity(l, {}, tilted(80)), 0.0546958164, 2e-5);  // cut by the horizon
    EXPECT_NEAR(mean_intensity(bulb<TypeParam>({3, -4, 12}, 5), {}, normalize(Vec3d{3, -4, 12})), 25.0 / 169, 1e-5);
}

TYPED_TEST(Lights, SphereSamplesLieOnTheNearSide) {
    const auto l = bulb<TypeParam>({3, -4, 12}, 5);
    for (int i = 0; i < 100; ++i) {
        const LightSample<TypeParam> s =
            sample_light(l, {}, {TypeParam(i / 10 + 0.5) / 10, TypeParam(i % 10 + 0.5) / 10});
        EXPECT_NEAR(double(length(s.wi * s.distance - l.center)), 5, sizeof(TypeParam) == 4 ? 2e-5 : 1e-13);
        EXPECT_LT(dot(s.wi * s.distance - l.center, s.wi), 0);
    }
}

TYPED_TEST(Lights, ALegacyBulbIsAFacingDiscOfTheSamePower) {
    const auto l = bulb<TypeParam>({0, 0, 2}, 1, true);
    double sum = 0;
    for (int i = 0; i < 1000; ++i) {
        const LightSample<TypeParam> s = sample_light(l, {}, {TypeParam(i + 0.5) / 1000, TypeParam(0.37)});
        EXPECT_FLOAT_EQ(intensity(s).r, 0.25f);
        const double r = double(length(s.wi * s.distance - l.center));
        EXPECT_NEAR(double((s.wi * s.distance).z), 2, 1e-6);
        EXPECT_NEAR(r, (i + 0.5) / 1000, 1e-6);  // the radius is uniform
        sum += r;
    }
    EXPECT_NEAR(sum / 1000, 0.5, 1e-6);
}

TYPED_TEST(Lights, TinySpheresAreAsBrightAsPoints) {
    for (const double ratio : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        const double radius = 3 * ratio, intensity = pi<double> * radius * radius;  // radiance 1
        const double expected = intensity / 9 * inv_pi * std::cos(radians(30));
        const double found = mean_intensity(bulb<TypeParam>({0, 0, 3}, radius), {}, tilted(30), 20);
        EXPECT_NEAR(found / expected, 1, 1e-4) << ratio;
        const auto p = point<TypeParam>({0, 0, 3});
        EXPECT_NEAR(mean_intensity(p, {}, tilted(30), 1) * intensity / expected, 1, 1e-6);
    }
}

TYPED_TEST(Lights, SpheresAreDarkInsideAndFiniteAtTheSurface) {
    for (const bool radial : {false, true}) {
        const auto l = bulb<TypeParam>({1, 2, 3}, 2, radial);
        const Vec2<TypeParam> u{TypeParam(0.3), TypeParam(0.7)};
        for (const double d : {0.0, 0.5, 1.999})
            EXPECT_FALSE(sample_light(l, Vec3<TypeParam>(Vec3d{1, 2 + d, 3}), u).lit);
        const LightSample<TypeParam> s = sample_light(l, Vec3<TypeParam>(Vec3d{1, 4.00001, 3}), u);
        EXPECT_TRUE(s.lit);
        EXPECT_GT(intensity(s).r, 0.9f);
        EXPECT_LE(intensity(s).r, 2.001f);  // a half space of radiance 1, by the pdf of half the directions
    }
}

// ---- points and falloff
// ----------------------------------------------------------------------------------------------

TYPED_TEST(Lights, PointsFallOffWithTheSquareAndStayFinite) {
    const auto l = point<TypeParam>({0, 0, 0});
    for (const double d : {1e-3, 1.0, 7.0, 1e3}) {
        const LightSample<TypeParam> s = sample_light(l, Vec3<TypeParam>(Vec3d{0, d, 0}), {});
        EXPECT_TRUE(s.lit);
        EXPECT_NEAR(double(intensity(s).r) * d * d, inv_pi, 1e-6);
        EXPECT_NEAR(double(s.distance), d, 1e-6 * d);
    }
    EXPECT_FALSE(sample_light(l, {}, {}).lit);  // at the light itself
    const LightSample<TypeParam> near = sample_light(l, {0, TypeParam(1e-18), 0}, {});
    EXPECT_TRUE(std::isfinite(intensity(near).r));
    EXPECT_GT(intensity(near).r, 1e29f);
}

TYPED_TEST(Lights, WithoutFalloffTheIntensityIsTheColour) {
    auto p = point<TypeParam>({0, 0, 500});
    auto r = rect<TypeParam>({-1, -1, 500}, {2, 0, 0}, {0, 2, 0});
    auto s = bulb<TypeParam>({0, 0, 500}, 3), legacy = bulb<TypeParam>({0, 0, 500}, 3, true);
    const Color color{0.25f, 0.5f, 2.0f};
    const Vec2<TypeParam> u{TypeParam(0.3), TypeParam(0.7)};
    const auto check = [&](auto light) {
        light.color = color;
        light.inverse_square = false;
        const LightSample<TypeParam> sample = sample_light(light, {}, u);
        EXPECT_TRUE(sample.lit);
        EXPECT_EQ(intensity(sample), color);
    };
    check(p), check(r), check(s), check(legacy);
}

// ---- lanes
// -----------------------------------------------------------------------------------------------------------

template <class Real, class R>
void expect_lane(const LightSample<R>& lanes, int i, const LightSample<Real>& one) {
    constexpr double eps = 16 * std::numeric_limits<Real>::epsilon();
    EXPECT_EQ(lane_bit(lanes.lit, i), one.lit);
    if (!one.lit) return;
    EXPECT_NEAR(double(lane(lanes.wi.x, i)), double(one.wi.x), eps);
    EXPECT_NEAR(double(lane(lanes.wi.y, i)), double(one.wi.y), eps);
    EXPECT_NEAR(double(lane(lanes.wi.z, i)), double(one.wi.z), eps);
    EXPECT_NEAR(double(lane(lanes.distance, i)), double(one.distance), eps * 20);
    EXPECT_NEAR(lane(lanes.radiance.g, i), one.radiance.g, 4e-6f * one.radiance.g);
    EXPECT_NEAR(lane(lanes.pdf, i), one.pdf, 4e-6f * one.pdf);
    EXPECT_EQ(lane_bit(lanes.is_delta, i), one.is_delta);
}

// Each lane its own light, picked by index, against that light alone.
template <class Real, template <class> class Kind>
void expect_picked(const std::vector<Kind<Real>>& lights) {
    using P = Pack<Real>;
    using R = typename P::R;
    using I = typename P::I;
    std::mt19937 engine(7);
    for (int k = 0; k < 50; ++k) {
        I index(0);
        Vec3<R> p;
        Vec2<R> u;
        const auto random = [&] { return Real(engine() >> 8) * Real(0x1p-24); };
        for (int i = 0; i < P::width; ++i) {
            index[i] = int(engine() % lights.size());
            p.x[i] = random() * 4 - 2, p.y[i] = random() * 4 - 2, p.z[i] = random();
            u.x[i] = random(), u.y[i] = random();
        }
        const Kind<R> picked = pick<R>(lights, index);
        const LightSample<R> lanes = sample_light(picked, p, u);
        for (int i = 0; i < P::width; ++i) {
            const Kind<Real>& light = lights[size_t(index[i])];
            EXPECT_EQ(lane(picked.color.b, i), light.color.b);
            EXPECT_EQ(lane(picked.body, i), light.body);
            EXPECT_EQ(lane_bit(picked.inverse_square, i), light.inverse_square);
            const Vec3<Real> pi{lane(p.x, i), lane(p.y, i), lane(p.z, i)};
            expect_lane<Real>(lanes, i, sample_light(light, pi, {lane(u.x, i), lane(u.y, i)}));
        }
    }
}

template <class Light>
void vary(std::vector<Light>& lights) {
    for (size_t i = 0; i < lights.size(); ++i) {
        lights[i].color = Color{float(i) + 1, float(i) * 0.5f + 1, 3.0f - float(i) * 0.1f};
        lights[i].inverse_square = i % 3 != 0;
        lights[i].body = int(i) - 1;
    }
}

TYPED_TEST(Lights, ALaneSeesThePickedLight) {
    using Real = TypeParam;
    std::vector<PointLightData<Real>> points;
    std::vector<RectLightData<Real>> rects;
    std::vector<SphereLightData<Real>> spheres;
    for (int i = 0; i < 11; ++i) {
        const Vec3d at{double(i) - 5, 0.3 * i, 4};
        points.push_back(point<Real>(at));
        rects.push_back(rect<Real>(at, {1, 0.1 * i, 0}, {0.1 * i, -1, 0}, i % 2 == 0));
        spheres.push_back(bulb<Real>(at, 0.2 + 0.2 * i, i % 2 == 0));
    }
    vary(points), vary(rects), vary(spheres);
    expect_picked(points), expect_picked(rects), expect_picked(spheres);
}

// ---- the densities of the samples ----------------------------------------------------------------------------------

template <class Real>
Vec2<Real> random_point(std::uint32_t i) {
    const Vec2<float> u = sample_2d(SamplerKind::independent, SampleSet<float>{99u, i}, 2);
    return {Real(u.x), Real(u.y)};
}

const double chi2_level = test::sidak(0.01, 10);

TYPED_TEST(Lights, RectanglesAreSampledUniformly) {
    using V = Vec3<TypeParam>;
    const auto l = rect<TypeParam>({-1, 0.3, 3}, {1, 0.5, 0.4}, {0.2, -1.5, 0.1});
    const V p{1, 2, 0}, across_x = cross(l.edge_y, l.normal), across_y = cross(l.edge_x, l.normal);
    EXPECT_GT(test::uniformity([&](std::uint32_t i) {
                  const LightSample<TypeParam> s = sample_light(l, p, random_point<TypeParam>(i));
                  const V q = p + s.wi * s.distance - l.corner;
                  return Vec2d{double(dot(q, across_x) / dot(l.edge_x, across_x)),
                               double(dot(q, across_y) / dot(l.edge_y, across_y))};
              }),
              chi2_level);
}

TYPED_TEST(Lights, SpheresAreSampledUniformlyInSolidAngle) {
    const auto l = bulb<TypeParam>({0, 0, 5}, 3);
    const double cap = 1 - std::sqrt(1 - 9.0 / 25);
    EXPECT_GT(test::uniformity([&](std::uint32_t i) {
                  const Vec3d wi(sample_light(l, {}, random_point<TypeParam>(i)).wi);
                  return Vec2d{(1 - wi.z) / cap, test::turn_of(wi.y, wi.x)};
              }),
              chi2_level);
}

TYPED_TEST(Lights, LegacyBulbsAreSampledUniformlyInRadius) {
    const auto l = bulb<TypeParam>({0, 0, 5}, 3, true);
    EXPECT_GT(test::uniformity([&](std::uint32_t i) {
                  const auto s = sample_light(l, {}, random_point<TypeParam>(i));
                  const Vec3d q(s.wi * s.distance);
                  return Vec2d{std::sqrt(q.x * q.x + q.y * q.y) / 3, test::turn_of(q.y, q.x)};
              }),
              chi2_level);
}

}  // namespace
}  // namespace drt
