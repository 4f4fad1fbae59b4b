// Rays of one view: the film's geometry, the lens, where it is sharp.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drt/camera/camera_model.h"

namespace drt {
namespace {

CameraModel<double> still_camera(double fov_degrees, double focus) {
    CameraModel<double> m;
    m.film = {400, 300};
    m.eye = {{1, 2, 3}};
    m.view = {{3, -1, -8}};
    m.pixel_width = {2 * std::tan(radians(fov_degrees) / 2) / m.film.width};
    m.focus = {focus};
    return m;
}

std::vector<Vec2d> random_square(int n) {
    std::mt19937_64 engine(1);
    const auto u = [&] { return double(engine() >> 11) * 0x1p-53; };
    std::vector<Vec2d> out;
    for (int i = 0; i < n; ++i) out.push_back({u(), u()});
    return out;
}

// ---- the film
// --------------------------------------------------------------------------------------------------------

// Straight from the definition: the width subtends the field of view, pixels are square, y goes down.
Vec3d slow_direction(const CameraModel<double>& m, double fov_degrees, double x, double y) {
    using L = long double;
    using V = Vec3<L>;
    const V forward = normalize(V(m.view[0]));
    const V right = normalize(cross(forward, V(m.up[0])));
    const V up = cross(right, forward);
    const L half_width = std::tan(radians(L(fov_degrees)) / 2);
    const L half_height = half_width * m.film.height / m.film.width;
    const V d = forward + right * (half_width * (2 * L(x) / m.film.width - 1)) +
                up * (half_height * (1 - 2 * L(y) / m.film.height));
    return Vec3d(normalize(d));
}

TEST(CameraRay, CornersAreExactFromATelescopeToAnAllRoundView) {
    for (const double fov : {1e-3, 1.0, 45.0, 120.0, 179.0, 179.9}) {
        const CameraModel<double> m = still_camera(fov, 1);
        const View<double> v = view_at(m, 0.0);
        for (const double x : {0.0, 123.4, 400.0})
            for (const double y : {0.0, 77.7, 300.0}) {
                const CameraRay<double> r = camera_ray<false, double>(v, m.film, m.lens, {x, y}, {});
                EXPECT_LE(length(r.d - slow_direction(m, fov, x, y)), 1e-12) << fov;
                EXPECT_NEAR(length(r.d), 1, 1e-15);
                EXPECT_EQ(r.o, m.eye[0]);
            }
    }
}

TEST(CameraRay, TheCentreLooksAtTheTargetAndUpIsUp) {
    const CameraModel<double> m = still_camera(60, 1);
    const View<double> v = view_at(m, 0.0);
    const auto at = [&](double x, double y) { return camera_ray<false, double>(v, m.film, m.lens, {x, y}, {}).d; };
    EXPECT_LE(length(at(200, 150) - normalize(m.view[0])), 1e-15);
    EXPECT_GT(at(200, 0).y, at(200, 300).y);
    EXPECT_GT(dot(at(400, 150), cross(v.forward, Vec3d{0, 1, 0})), 0);  // x grows to the right
}

// ---- the lens
// --------------------------------------------------------------------------------------------------------

// f = 50 mm at f/2, focused at 5 m: circles of confusion on the sensor by the thin lens formula.
TEST(Lens, CirclesOfConfusionAreThoseOfAThinLens) {
    constexpr double f = 0.05, aperture = f / 2, focus = 5, sensor = f * focus / (focus - f);
    CameraModel<double> m = still_camera(40, focus);
    m.lens.radius = aperture / 2;
    const View<double> v = view_at(m, 0.0);
    const auto lens_uv = random_square(20000);
    const struct {
        double distance, expected;
    } cases[] = {{2.5, 2.525253e-4}, {5, 0}, {10, 1.262626e-4}, {1e9, 2.525253e-4}};
    for (const auto& c : cases) {
        double radius = 0;
        for (const Vec2d& u : lens_uv) {
            const CameraRay<double> r = camera_ray<true, double>(v, m.film, m.lens, {200, 150}, u);
            const Vec3d p = (r.o - v.eye) + r.d * ((c.distance - dot(r.o - v.eye, v.forward)) / dot(r.d, v.forward));
            radius = std::max(radius, length(p - v.forward * c.distance));
        }
        EXPECT_NEAR(2 * radius / c.distance * sensor, c.expected, 0.005 * 2.5e-4) << c.distance;
    }
}

TEST(Lens, EveryRayOfAPixelMeetsInTheSurfaceOfFocus) {
    for (const bool sphere : {false, true}) {
        CameraModel<double> m = still_camera(70, 7);
        m.lens = {0.3, false, sphere};
        const View<double> v = view_at(m, 0.0);
        for (const Vec2d position : {Vec2d{0, 0}, Vec2d{200, 150}, Vec2d{333, 12}}) {
            const Vec3d d = slow_direction(m, 70, position.x, position.y);
            const Vec3d sharp = v.eye + d * (sphere ? 7 : 7 / dot(d, v.forward));
            double worst = 0;
            for (const Vec2d& u : random_square(1000)) {
                const CameraRay<double> r = camera_ray<true, double>(v, m.film, m.lens, position, u);
                worst = std::max(worst, length(cross(sharp - r.o, r.d)));
                EXPECT_NEAR(dot(r.o - v.eye, v.forward), 0, 1e-15);
                EXPECT_LE(length(r.o - v.eye), 0.3 * (1 + 1e-12));
            }
            EXPECT_LE(worst, 1e-13);
        }
    }
}

// The share of the disc beyond a line at distance t (of the radius) from the centre, and its legacy counterpart.
double uniform_share(double t) { return (std::acos(t) - t * std::sqrt(1 - t * t)) / pi<double>; }
// Density 1 / (2 pi r): the integral over r from t to 1 of acos(t / r) / pi.
double radial_share(double t) {
    double sum = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) sum += std::acos(t / (t + (1 - t) * (i + 0.5) / n));
    return sum * (1 - t) / n / pi<double>;
}

TEST(Lens, IsCoveredAsItsDistributionSays) {
    constexpr int n = 100000;
    const auto lens_uv = random_square(n);
    for (const bool radial : {false, true}) {
        CameraModel<double> m = still_camera(70, 7);
        m.lens = {0.3, radial, false};
        const View<double> v = view_at(m, 0.0);
        for (const double t : {0.0, 0.2, 0.5, 0.9}) {
            int beyond_x = 0, beyond_y = 0;
            for (const Vec2d& u : lens_uv) {
                const Vec3d o = camera_ray<true, double>(v, m.film, m.lens, {200, 150}, u).o - v.eye;
                beyond_x += dot(o, v.right) > t * 0.3;
                beyond_y += dot(o, v.up) > t * 0.3;
            }
            const double p = radial ? radial_share(t) : uniform_share(t);
            const double four_sigma = 4 * std::sqrt(n * p * (1 - p));
            EXPECT_NEAR(beyond_x, n * p, four_sigma) << radial << " " << t;
            EXPECT_NEAR(beyond_y, n * p, four_sigma) << radial << " " << t;
        }
    }
}

TEST(Lens, OfNoSizeIsAPinhole) {
    const CameraModel<double> m = still_camera(70, 7);
    const View<double> v = view_at(m, 0.0);
    for (const Vec2d& u : random_square(100)) {
        const Vec2d position{400 * u.x, 300 * u.y};
        const CameraRay<double> with = camera_ray<true, double>(v, m.film, m.lens, position, u);
        const CameraRay<double> without = camera_ray<false, double>(v, m.film, m.lens, position, u);
        EXPECT_EQ(with.o, without.o);
        EXPECT_LE(length(with.d - without.d), 1e-15);
    }
}

// ---- the view over time
// ----------------------------------------------------------------------------------------------

TEST(View, AnImplicitFocusIsTheTargets) {
    CameraModel<double> m = still_camera(60, 0);
    EXPECT_NEAR(view_at(m, 0.3).focus, length(m.view[0]), 1e-14);
    m.focus = {3, 1};
    EXPECT_NEAR(view_at(m, 0.25).focus, 2.5, 1e-15);
}

TEST(View, FollowsAPathAndTurnsWithIt) {
    CameraModel<double> m = still_camera(60, 0);
    MotionPiece<double> p;
    p.c0 = m.eye[0];
    p.c1 = {10, 0, 0};
    p.axis = {0, 1, 0};
    p.angle = pi<double>;  // half a turn about the vertical
    m.path = {p};
    const View<double> a = view_at(m, 0.0), b = view_at(m, 1.0), middle = view_at(m, 0.5);
    EXPECT_LE(length(b.eye - (a.eye + Vec3d{10, 0, 0})), 1e-14);
    EXPECT_LE(length(b.forward - Vec3d{-a.forward.x, a.forward.y, -a.forward.z}), 1e-14);
    EXPECT_NEAR(middle.forward.y, a.forward.y, 1e-15);
    EXPECT_LE(std::abs(dot(middle.forward, middle.up)), 1e-15);
    EXPECT_LE(std::abs(dot(middle.forward, middle.right)), 1e-15);
    EXPECT_NEAR(b.focus, a.focus, 1e-14);
}

}  // namespace
}  // namespace drt
