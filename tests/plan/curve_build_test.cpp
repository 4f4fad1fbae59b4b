// Curves over an exposure, against long double.

#include "drt/plan/curve_build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drt/base/constants.h"

namespace drt {
namespace {

using L = long double;

Vec3<L> de_casteljau(const std::vector<Vec3d>& control, L s) {
    std::vector<Vec3<L>> points(control.begin(), control.end());
    for (; points.size() > 1; points.pop_back())
        for (size_t i = 0; i + 1 < points.size(); ++i) points[i] = points[i] * (1 - s) + points[i + 1] * s;
    return points.front();
}

std::vector<Vec3d> random_points(size_t n, double size) {
    std::mt19937 engine{unsigned(n)};
    std::uniform_real_distribution<double> in(-size, size);
    std::vector<Vec3d> points;
    for (size_t i = 0; i < n; ++i) points.push_back({in(engine), in(engine), in(engine)});
    return points;
}

constexpr Stretch stretches[] = {{0, 0},      {0.3, 0.3}, {1, 1},     {0, 0.04},      {0.96, 1},
                                 {0.5, 0.51}, {0, 1},     {0.1, 0.9}, {0.999999, 1.0}};

double worst_error(const Curve<Vec3d>& curve, const std::vector<Vec3d>& points, const Stretch& s) {
    double worst = 0;
    for (int i = 0; i <= 16; ++i) {
        const L x = L(i) / 8 - 1;
        const L at = (L(s.from) * (1 - x) + L(s.to) * (1 + x)) / 2;
        const Vec3<L> d = Vec3<L>(value_at<Vec3d>(curve, double(x))) - de_casteljau(points, at);
        worst = std::max(worst, double(length(d)));
    }
    return worst;
}

TEST(BezierPoint, IsExactForAnyNumberOfPoints) {
    for (const size_t n : {1, 2, 3, 4, 8, 20, 100, 129, 130, 300, 1100, 3000}) {
        const std::vector<Vec3d> points = random_points(n, 1);
        for (const double s : {0.0, 1e-300, 1e-9, 0.01, 0.3, 0.5, 0.77, 0.999, 1 - 1e-16, 1.0}) {
            const Vec3<L> d = Vec3<L>(bezier_point(points, s)) - de_casteljau(points, s);
            EXPECT_LE(double(length(d)), 2e-15) << n << " points, s = " << s;
        }
    }
}

TEST(BezierCurve, IsExactForAnyNumberOfPoints) {
    for (const size_t n : {1, 2, 3, 4, 5, 6, 8, 20, 129, 130, 300, 1100})
        for (const Stretch& s : stretches) {
            const std::vector<Vec3d> points = random_points(n, 1);
            // a curve of n points may go n times their size in its unit of time, whose rounding it follows
            EXPECT_LE(worst_error(bezier_curve(points, s), points, s), 1e-14 + 1e-15 * double(n))
                << n << " points, " << s.from << " to " << s.to;
        }
}

TEST(BezierCurve, KeepsTheDigitsOfDifferencesFarAway) {
    std::vector<Vec3d> points = random_points(5, 0x1p-10);
    for (Vec3d& p : points) p = Vec3d(Vec3f(p)) + Vec3d{0x1p20, -0x1p20, 0x1p18};
    Curve<Vec3d> c = bezier_curve(points, {0.2, 0.3});
    c[0] -= points[0];
    std::vector<Vec3d> near;
    for (const Vec3d& p : points) near.push_back(p - points[0]);
    EXPECT_LE(worst_error(c, near, {0.2, 0.3}), 2e-10);  // that of c[0] alone
    c[0] = {};
    EXPECT_LE(length(c[1]), 1e-3);
}

TEST(BezierCurve, HasNoMoreTermsThanItNeeds) {
    EXPECT_EQ(bezier_curve({{1, 2, 3}}, {0, 1}), (Curve<Vec3d>{{1, 2, 3}}));
    EXPECT_EQ(bezier_curve({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {0.1, 0.2}), (Curve<Vec3d>{{1, 2, 3}}));
    EXPECT_EQ(bezier_curve(random_points(7, 1), {0.3, 0.3}).size(), 1u);
    EXPECT_EQ(bezier_curve({{0, 0, 0}, {1, 0, 0}}, {0, 0.5}).size(), 2u);
    EXPECT_EQ(bezier_curve({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {0, 0.5}).size(), 2u);  // straight
    EXPECT_EQ(bezier_curve({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {0, 1}).size(), 3u);
    EXPECT_LE(bezier_curve(random_points(300, 1), {0.5, 0.51}).size(), 12u);
    EXPECT_LE(bezier_curve(random_points(100000, 1), {0.5, 0.51}).size(), 65u);
}

TEST(LinearCurve, MeetsItsEnds) {
    EXPECT_EQ(linear_curve(3.0, 7.0, {0.25, 0.25}), Curve<double>{4});
    EXPECT_EQ(linear_curve(3.0, 3.0, {0, 1}), Curve<double>{3});
    EXPECT_EQ(linear_curve(3.0, 7.0, {0, 1}), (Curve<double>{5, 2}));
    EXPECT_EQ(linear_curve(3.0, 7.0, {0.5, 1}), (Curve<double>{6, 1}));
}

TEST(AngleCurves, AreSinesAndCosines) {
    for (const auto& [start, end] : {std::pair{0.3, 0.3}, {0.2, 0.9}, {1.5, 0.01}, {0.0, pi<double> / 2}})
        for (const Stretch& s : stretches) {
            const Curve<double> sine = sine_curve(start, end, s), cosine = cosine_curve(start, end, s);
            EXPECT_LE(sine.size(), 17u);
            for (double x = -1; x <= 1; x += 0.125) {
                const double angle = start + (end - start) * (s.from + (s.to - s.from) * (x + 1) / 2);
                EXPECT_NEAR(value_at<double>(sine, x), std::sin(angle), 2e-15);
                EXPECT_NEAR(value_at<double>(cosine, x), std::cos(angle), 2e-15);
            }
        }
}

}  // namespace
}  // namespace drt
