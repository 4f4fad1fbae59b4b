// Every shape of collider in contact, by what is known of it without computing.

#include <gtest/gtest.h>

#include <cmath>

#include "drt/dynamics/audit.h"
#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

constexpr double g = 9.81;

RigidBody cylinder(const Vec3d& position, double radius, double half_height) {
    RigidBody b = ball(position, 0);
    b.collider = CylinderCollider{radius, half_height};
    const double across = 0.25 * radius * radius + half_height * half_height / 3;
    b.inertia = {across, across, 0.5 * radius * radius};
    return b;
}

RigidBody plate(const Collider& c, const Vec3d& position) {
    RigidBody b;
    b.collider = c;
    b.start.position = position;
    return b;
}

PolygonCollider triangle() { return {{{-6, 0, -4}, {0, 0, 8}, {6, 0, -4}}}; }

RigidState end_of(const RigidScene& scene, size_t body, double end, double step = 1.0 / 96) {
    const Simulation r = simulate(scene, 0, end, step);
    EXPECT_LE(r.deepest_overlap, 1e-3);
    EXPECT_LE(audit(scene, r.tracks, end).energy_rise, 1e-3);
    return state_at(scene.bodies[body], r.tracks[body], end);
}

const Quatd upright = quat_from_axis_angle({1, 0, 0}, -pi<double> / 2);  // a cylinder's axis is z

TEST(Shapes, ACylinderStands) {
    for (const Collider& under : {Collider{PlaneCollider{}}, Collider{BoxCollider{{4, 1, 4}}}, Collider{triangle()},
                                  Collider{DiscCollider{{0, 1, 0}, 4}}}) {
        const double top = std::holds_alternative<BoxCollider>(under) ? 1 : 0;
        RigidScene scene{{plate(under, {0, 0, 0}), cylinder({0, top + 1.5, 0}, 1, 1.5)}, {0, -g, 0}};
        scene.bodies[1].start.orientation = upright;
        const RigidState s = end_of(scene, 1, 20);
        EXPECT_LE(length(s.position - Vec3d{0, top + 1.5, 0}), 2e-3) << under.index();
        EXPECT_GE(rotate(s.orientation, Vec3d{0, 0, 1}).y, 1 - 1e-4) << under.index();
    }
}

// On its side, pushed without spin, it slides until it rolls at two thirds of its speed.
TEST(Shapes, ACylinderEndsRolling) {
    RigidScene scene{{floor_body(), cylinder({0, 1, 0}, 1, 2)}, {0, -g, 0}};
    scene.bodies[1].start.velocity = {6, 0, 0};
    const RigidState s = end_of(scene, 1, 2);
    EXPECT_NEAR(s.velocity.x, 4, 1e-3);
    EXPECT_NEAR(s.spin.z, -4, 1e-3);
    EXPECT_NEAR(s.position.y, 1, 1e-5);
    EXPECT_NEAR(s.position.z, 0, 1e-6);
}

// It rolls down a slope at two thirds of what it would slide without friction.
TEST(Shapes, ACylinderRollsDownASlope) {
    const double angle = 0.2;
    RigidScene scene{{floor_body(), cylinder({0, 1, 0}, 1, 1)}, Vec3d{std::sin(angle), -std::cos(angle), 0} * g};
    const RigidState s = end_of(scene, 1, 2);
    EXPECT_NEAR(s.position.x, 2.0 / 3 * g * std::sin(angle) * 2, 1e-3);
}

// On a box as on a plane: there are two points of a line, and nothing brakes.
TEST(Shapes, ACylinderRollsStraightOnABox) {
    for (const Collider& under : {Collider{BoxCollider{{40, 1, 10}}}, Collider{DiscCollider{{0, 1, 0}, 40}}}) {
        const double top = std::holds_alternative<BoxCollider>(under) ? 1 : 0;
        RigidScene scene{{plate(under, {0, 0, 0}), cylinder({0, top + 1, 0}, 1, 1)}, {0, -g, 0}};
        scene.bodies[1].start.velocity = {5, 0, 0};
        scene.bodies[1].start.spin = {0, 0, -5};
        const RigidState s = end_of(scene, 1, 4);
        EXPECT_LE(length(s.position - Vec3d{20, top + 1, 0}), 1e-3) << under.index();
        EXPECT_NEAR(s.velocity.x, 5, 1e-3) << under.index();
    }
}

// What falls tilted on something flat, or is long and thin, comes to its end without being given up.
TEST(Shapes, WhatFallsTiltedComesDown) {
    RigidBody tilted_cylinder = cylinder({0, 4, 0}, 1, 1), tilted_box = box({0, 4, 0}, {1, 1, 1}, 0.3),
              rod = box({0, 4, 0}, {20, 1, 1}, 0.3), pencil = cylinder({0, 4, 0}, 1, 12);
    for (RigidBody* b : {&tilted_cylinder, &tilted_box, &rod, &pencil}) {
        b->restitution = 0.3;
        b->start.orientation = quat_from_axis_angle(normalize(Vec3d{1, 0.2, 0}), b == &rod || b == &pencil ? 0.1 : 0.8);
        for (const Collider& under : {Collider{BoxCollider{{40, 1, 40}}}, Collider{DiscCollider{{0, 1, 0}, 40}}}) {
            const double top = std::holds_alternative<BoxCollider>(under) ? 1 : 0;
            const RigidScene scene{{plate(under, {0, 0, 0}), *b}, {0, -g, 0}};
            const Simulation r = simulate(scene, 0, 4, 1.0 / 96);
            EXPECT_GT(r.given_up.time, 4) << b->collider.index() << " on " << under.index();
            const double height = state_at(*b, r.tracks[1], 4).position.y - top;
            EXPECT_GE(height, 0.99) << b->collider.index() << " on " << under.index();
            EXPECT_LE(height, 1.42) << b->collider.index() << " on " << under.index();
            EXPECT_LE(audit(scene, r.tracks, 4).energy_rise, 2e-3) << b->collider.index() << " on " << under.index();
        }
    }
}

TEST(Shapes, ABallRollsOffATriangleAndADisc) {
    for (const Collider& under : {Collider{triangle()}, Collider{DiscCollider{{0, 1, 0}, 4}}}) {
        RigidScene scene{{plate(under, {0, 0, 0}), ball({0, 1, 0}, 0.3)}, {0, -g, 0}};
        scene.bodies[1].start.velocity = {3, 0, 0};
        scene.bodies[1].start.spin = {0, 0, -3};
        const RigidState on = end_of(scene, 1, 0.5), off = end_of(scene, 1, 3);
        EXPECT_LE(length(on.position - Vec3d{1.5, 1, 0}), 1e-6) << under.index();
        EXPECT_LT(off.position.y, -5) << under.index();
        EXPECT_GE(off.velocity.x, 2.9) << under.index();  // tipping over the edge pushes it on
    }
}

TEST(Shapes, ABoxRestsOnATriangleAndADisc) {
    for (const Collider& under : {Collider{triangle()}, Collider{DiscCollider{{0, 1, 0}, 4}}}) {
        RigidScene scene{{plate(under, {0, 0, 0}), box({0, 1.5, 0}, {1, 1, 1}, 0)}, {0, -g, 0}};
        scene.bodies[1].start.orientation = quat_from_axis_angle({0, 1, 0}, 0.4);
        const RigidState s = end_of(scene, 1, 20);
        const bool is_disc = std::holds_alternative<DiscCollider>(under);  // where GJK finds one corner after the other
        EXPECT_LE(length(s.position - Vec3d{0, 1, 0}), is_disc ? 0.02 : 2e-3) << under.index();
    }
}

// Plates are solid from below, too.
TEST(Shapes, ABallBouncesOffAPlateFromBelow) {
    for (const Collider& over : {Collider{triangle()}, Collider{DiscCollider{{0, 1, 0}, 4}}}) {
        RigidScene scene{{plate(over, {0, 0, 0}), ball({0.3, -4, 0}, 1)}, {}};
        scene.bodies[1].friction = 0;
        scene.bodies[1].start.velocity = {0, 2, 0};
        const RigidState s = end_of(scene, 1, 3);
        EXPECT_LE(length(s.position - Vec3d{0.3, -4, 0}), 1e-9) << over.index();
        EXPECT_NEAR(s.velocity.y, -2, 1e-12);
    }
}

TEST(Shapes, ACylinderFallsOverAndComesToRest) {
    RigidScene scene{{floor_body(), cylinder({0, 3.2, 0}, 1, 2)}, {0, -g, 0}};
    scene.bodies[1].start.orientation = quat_from_axis_angle({0, 0, 1}, 0.7) * upright;
    scene.bodies[1].rolling_friction = 0.02;
    const RigidState s = end_of(scene, 1, 40);
    EXPECT_NEAR(rotate(s.orientation, Vec3d{0, 0, 1}).y, 0, 1e-3);
    EXPECT_NEAR(s.position.y, 1, 1e-3);
    EXPECT_LE(length(s.velocity), 1e-3);
}

}  // namespace
}  // namespace drt
