// Contact of flat faces.

#include "drt/dynamics/polytope.h"

#include <gtest/gtest.h>

#include <random>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

RigidState at(const Vec3d& position, const Quatd& orientation = {}) {
    RigidState s;
    s.position = position;
    s.orientation = orientation;
    return s;
}

TEST(Polytope, BoxesFaceToFaceTouchAtTheCornersOfTheirOverlap) {
    const Collider c = BoxCollider{{1, 1, 1}};
    const Polytope lower = make_polytope(c, at({0, 0, 0})), upper = make_polytope(c, at({0.5, 2.001, 0}));
    const Separation s = separate(upper, lower);
    EXPECT_NEAR(s.distance, 1e-3, 1e-14);
    EXPECT_LE(length(s.normal - Vec3d{0, 1, 0}), 1e-14);
    const auto points = contact_points(upper, lower, s, 0.01);
    ASSERT_EQ(points.size(), 4u);
    Vec3d sum;
    for (const SurfacePoint& p : points) {
        EXPECT_NEAR(p.gap, 1e-3, 1e-14);
        EXPECT_NEAR(p.on_a.y, 1.001, 1e-14);
        EXPECT_NEAR(p.on_b.y, 1, 1e-14);
        EXPECT_NEAR(std::abs(p.on_b.z), 1, 2e-9);  // outlines count to 1e-9 beyond their edges
        EXPECT_NEAR(std::abs(p.on_b.x - 0.25), 0.75, 2e-9);
        sum += p.on_b;
    }
    EXPECT_LE(length(sum - Vec3d{1, 4, 0}), 1e-8);
    EXPECT_TRUE(contact_points(upper, lower, s, 1e-4).empty());
}

// Two squares turned against each other overlap in an octagon, and a box would tip over any corner that is left out.
TEST(Polytope, TurnedBoxesTouchAtEightPoints) {
    const Collider c = BoxCollider{{1, 1, 1}};
    const Polytope lower = make_polytope(c, at({0, 0, 0})),
                   upper = make_polytope(c, at({0, 2, 0}, quat_from_axis_angle({0, 1, 0}, pi<double> / 4)));
    const auto points = contact_points(upper, lower, separate(upper, lower), 0.01);
    ASSERT_EQ(points.size(), 8u);
    for (const SurfacePoint& p : points) {  // one coordinate is 1, the other sqrt(2) - 1
        const double x = std::abs(p.on_b.x), z = std::abs(p.on_b.z);
        EXPECT_NEAR(std::max(x, z), 1, 1e-8);
        EXPECT_NEAR(std::min(x, z), std::sqrt(2.0) - 1, 1e-8);
    }
}

// Tilted by a hair, crossed edges keep the two apart by more than their faces do; the other corners are near all the
// same.
TEST(Polytope, AlmostParallelFacesKeepTheirPoints) {
    const Collider c = BoxCollider{{1, 1, 1}};
    const double tilt = 1e-3;
    const Quatd turned = quat_from_axis_angle({1, 0, 0}, tilt) * quat_from_axis_angle({0, 1, 0}, 0.3);
    const Polytope lower = make_polytope(c, at({0, 0, 0})), upper = make_polytope(c, at({0, 2.0005, 0.2}, turned));
    const Separation s = prefer_faces(upper, lower, separate(upper, lower));
    EXPECT_GE(s.face_of_a + s.face_of_b, -1);
    const auto points = contact_points(upper, lower, s, 0.01);
    ASSERT_GE(points.size(), 6u);
    double least = 1, most = -1;
    for (const SurfacePoint& p : points) least = std::min(least, p.gap), most = std::max(most, p.gap);
    EXPECT_NEAR(least, s.distance, 1e-5);
    EXPECT_NEAR(most - least, 2 * tilt, 0.7e-3);
}

// Two boxes that lie across each other, both on an edge.
TEST(Polytope, CrossedEdgesTouchAtOnePoint) {
    const Collider c = BoxCollider{{1, 1, 5}};
    const double up = std::sqrt(2.0);
    const Quatd edge = quat_from_axis_angle({0, 0, 1}, pi<double> / 4);
    const Quatd across = quat_from_axis_angle({0, 1, 0}, pi<double> / 2) * edge;
    const Polytope lower = make_polytope(c, at({0, 0, 0}, edge)),
                   upper = make_polytope(c, at({0.3, 2 * up + 0.002, 0.2}, across));
    const Separation s = separate(upper, lower);
    EXPECT_NEAR(s.distance, 0.002, 1e-12);
    const auto points = contact_points(upper, lower, s, 0.01);
    ASSERT_EQ(points.size(), 1u);
    EXPECT_LE(length(points[0].on_b - Vec3d{0, up, 0.2}), 1e-12);
    EXPECT_LE(length(points[0].on_a - Vec3d{0, up + 0.002, 0.2}), 1e-12);
}

TEST(Polytope, ABoxOnASquareWithoutThickness) {
    const Collider square = PolygonCollider{{{-3, 0, -3}, {-3, 0, 3}, {3, 0, 3}, {3, 0, -3}}};
    for (const double side : {1.0, -1.0}) {  // solid from both
        const Polytope plate = make_polytope(square, at({0, 0, 0}));
        const Polytope box = make_polytope(BoxCollider{{1, 1, 1}}, at({0, side, 0}));
        const Separation s = separate(box, plate);
        EXPECT_NEAR(s.distance, 0, 1e-14);
        EXPECT_LE(length(s.normal - Vec3d{0, side, 0}), 1e-14);
        EXPECT_EQ(contact_points(box, plate, s, 1e-6).size(), 4u);
    }
}

// Against the definition: no axis separates two polytopes farther than they are apart, and none of 2000 random axes
// separates better than the one that is found.
TEST(Polytope, NoRandomAxisSeparatesBetter) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return normalize(Vec3d{normal(random), normal(random), normal(random)}); };
    const Collider c = BoxCollider{{1, 0.5, 2}};
    for (int k = 0; k < 50; ++k) {
        const Polytope a = make_polytope(c, at(direction() * 2.5, quat_from_axis_angle(direction(), normal(random))));
        const Polytope b = make_polytope(c, at({0, 0, 0}, quat_from_axis_angle(direction(), normal(random))));
        const Separation s = separate(a, b);
        const auto gap = [&](const Vec3d& n) {
            double least = 1e30, most = -1e30;
            for (const Vec3d& v : a.vertices) least = std::min(least, dot(v, n));
            for (const Vec3d& v : b.vertices) most = std::max(most, dot(v, n));
            return least - most;
        };
        EXPECT_NEAR(gap(s.normal), s.distance, 1e-12);
        if (s.distance > 0) continue;  // overlap: the smallest depth is among the candidate axes
        for (int i = 0; i < 2000; ++i) EXPECT_LE(gap(direction()), s.distance + 1e-9);
    }
}

}  // namespace
}  // namespace drt
