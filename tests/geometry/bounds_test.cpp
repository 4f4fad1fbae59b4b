#include "drt/geometry/bounds.h"

#include <gtest/gtest.h>

#include "drt/geometry/body_table.h"
#include "random_paths.h"

namespace drt {
namespace {

using test::Random;

Vec3d lerp(const Vec3d& a, const Vec3d& b, double t) { return a * (1 - t) + b * t; }

// Bounds at time u, as Embree interpolates them.
Bounds bounds_at(const std::vector<Bounds>& steps, double u) {
    if (steps.size() == 1) return steps[0];
    const double at = u * double(steps.size() - 1);
    const size_t i = std::min(size_t(at), steps.size() - 2);
    const double t = at - double(i);
    return {lerp(steps[i].lower, steps[i + 1].lower, t), lerp(steps[i].upper, steps[i + 1].upper, t)};
}

bool inside(const Bounds& b, const Vec3d& p, double slack) {
    for (int a = 0; a < 3; ++a)
        if (component(p, a) < component(b.lower, a) - slack || component(p, a) > component(b.upper, a) + slack)
            return false;
    return true;
}

// A random point of the surface, about the centre, extremes included.
Vec3d surface_point(const SphereShape<double>& s, Random& r) {
    const int axis = r.below(6);
    const double sign = axis % 2 ? -1 : 1;
    const Vec3d extreme{axis / 2 == 0 ? sign : 0, axis / 2 == 1 ? sign : 0, axis / 2 == 2 ? sign : 0};
    return (r.below(2) ? extreme : r.direction()) * s.radius;
}
Vec3d surface_point(const FlatShape<double>& s, Random& r) {
    const Vec3d e0 = cross(s.db, s.normal) / dot(cross(s.db, s.normal), s.da);
    const Vec3d e1 = cross(s.normal, s.da) / dot(cross(s.normal, s.da), s.db);
    const double turn = r.uniform(0, 6.3);
    if (s.outline == Outline::disc) return s.origin + e0 * std::cos(turn) + e1 * std::sin(turn);
    const int corner = r.below(s.outline == Outline::triangle ? 3 : 4);
    return s.origin + e0 * (corner % 2) + e1 * (corner / 2);
}
Vec3d surface_point(const BoxShape<double>& s, Random& r) {
    const auto side = [&] { return r.below(2) ? 1.0 : -1.0; };
    return s.ax * (s.half.x * side()) + s.ay * (s.half.y * side()) + s.az * (s.half.z * side());
}
Vec3d surface_point(const CylinderShape<double>& s, Random& r) {
    const double turn = r.uniform(0, 6.3), end = r.below(2) ? 1 : -1;
    return (s.ax * std::cos(turn) + s.ay * std::sin(turn)) * s.radius + s.az * (s.half_height * end);
}
Vec3d surface_point(const PlaneShape<double>&, Random&) { return {}; }

enum class Moves { not_at_all, straight_or_curved, turning };

template <class Real>
void expect_bounds_hold(Moves moves) {
    constexpr double eps = std::numeric_limits<Real>::epsilon();
    Random r(5);
    for (int k = 0; k < 140; ++k) {
        BodyInput in{test::random_shape(r, k % 7), r.in_box(10), {}};
        if (moves != Moves::not_at_all) in.path = test::random_path(r, 1 + k % 4, moves == Moves::turning);
        const BuiltTable<Real> built = build_body_table<Real>({in});
        const BodyGroup& g = built.table.groups.at(0);
        const std::vector<Bounds> steps = body_bounds(built.table, g, 0);
        ASSERT_EQ(steps.size(), size_t(g.time_steps));
        int outside = 0;
        for (int i = 0; i < 1000; ++i) {
            const double u = i == 0 ? 0 : i == 1 ? 1 : r.uniform(0, 1);
            const Pose<double> pose = in.path.empty() ? Pose<double>{in.center, {}} : test::slow_pose(in.path, u);
            const Vec3d p = std::visit([&](const auto& s) { return surface_point(s, r); }, in.shape);
            outside += !inside(bounds_at(steps, u), pose.center + rotate(pose.orientation, p), 100 * eps);
        }
        EXPECT_EQ(outside, 0) << "shape " << k % 7 << ", " << in.path.size() << " pieces, " << steps.size() << " steps";
    }
}

TEST(Bounds, ContainBodiesThatStandStill) {
    expect_bounds_hold<double>(Moves::not_at_all);
    expect_bounds_hold<float>(Moves::not_at_all);
}
TEST(Bounds, ContainBodiesThatMoveInACurveAndKeepTheirOrientation) {
    expect_bounds_hold<double>(Moves::straight_or_curved);
    expect_bounds_hold<float>(Moves::straight_or_curved);
}
TEST(Bounds, ContainBodiesThatTurn) {
    expect_bounds_hold<double>(Moves::turning);
    expect_bounds_hold<float>(Moves::turning);
}

TEST(Bounds, AreTightForBodiesThatStandStill) {
    Random r(6);
    for (int k = 0; k < 70; ++k) {
        const AnyShape shape = test::random_shape(r, k % 7);
        const Vec3d half = std::visit(
            [](const auto& s) -> Vec3d {
                if constexpr (std::is_same_v<std::decay_t<decltype(s)>, PlaneShape<double>>)
                    return {};
                else
                    return half_extent(s);
            },
            shape);
        Vec3d reached;
        for (int i = 0; i < 20000; ++i) {
            const Vec3d p = std::visit([&](const auto& s) { return surface_point(s, r); }, shape);
            reached = {std::max(reached.x, std::abs(p.x)), std::max(reached.y, std::abs(p.y)),
                       std::max(reached.z, std::abs(p.z))};
        }
        for (int a = 0; a < 3; ++a) {
            EXPECT_LE(component(reached, a), component(half, a) * (1 + 1e-12)) << k % 7;
            EXPECT_GE(component(reached, a), component(half, a) * (1 - 1e-4)) << k % 7;
        }
    }
}

TEST(Bounds, ChordDeviationIsWhatSamplingFinds) {
    Random r(7);
    for (int k = 0; k < 200; ++k) {
        const auto path = test::random_path(r, 1 + k % 4, false);
        const double u0 = r.uniform(0, 0.8), u1 = u0 + r.uniform(0.05, 1 - u0);
        const Vec3d found = chord_deviation(path, u0, u1);
        const Vec3d a = test::slow_pose(path, u0).center, b = test::slow_pose(path, u1).center;
        Vec3d sampled;
        constexpr int n = 2000;
        for (int i = 0; i <= n; ++i) {
            const double t = double(i) / n;
            const Vec3d d = test::slow_pose(path, u0 + (u1 - u0) * t).center - lerp(a, b, t);
            sampled = {std::max(sampled.x, std::abs(d.x)), std::max(sampled.y, std::abs(d.y)),
                       std::max(sampled.z, std::abs(d.z))};
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(component(found, axis), component(sampled, axis) - 1e-12);
            EXPECT_LE(component(found, axis), component(sampled, axis) + 0.02);  // between samples and at piece ends
        }
    }
}

// A parabola of sag h over the exposure: n intervals of time leave h / n^2.
TEST(Bounds, AsManyTimeStepsAsThePathIsCurved) {
    const Vec3d unit{1, 1, 1};
    const auto steps = [&](double sag) {
        MotionPiece<double> p;
        p.c1 = {10, 4 * sag, 0};
        p.c2 = {0, -4 * sag, 0};
        return time_steps_for(std::vector<MotionPiece<double>>{p}, unit);
    };
    EXPECT_EQ(steps(0), 2);
    EXPECT_EQ(steps(0.19), 2);
    EXPECT_EQ(steps(0.21), 3);
    EXPECT_EQ(steps(0.79), 3);
    EXPECT_EQ(steps(0.81), 5);
    EXPECT_EQ(steps(3.3), 9);
    EXPECT_EQ(steps(1e6), 17);
}

TEST(Bounds, OfStraightPathsAreNotWidened) {
    MotionPiece<double> p;
    p.c0 = {1, 2, 3};
    p.c1 = {5, 0, -1};
    const auto b = bounds_over_time(std::vector<MotionPiece<double>>{p}, {1, 1, 1}, 2);
    EXPECT_EQ(b[0].lower, (Vec3d{0, 1, 2}));
    EXPECT_EQ(b[1].upper, (Vec3d{7, 3, 3}));
}

TEST(Bounds, UnionIgnoresTheEmpty) {
    const Bounds a = around({1, 0, 0}, {1, 1, 1}), none;
    EXPECT_TRUE(none.empty());
    EXPECT_EQ(unite(a, none).lower, a.lower);
    EXPECT_EQ(unite(none, a).upper, a.upper);
    EXPECT_EQ(unite(a, around({-5, 0, 0}, {1, 1, 1})).lower, (Vec3d{-6, -1, -1}));
}

}  // namespace
}  // namespace drt
