// Impulses between bodies that touch, against the laws of collision.

#include <gtest/gtest.h>

#include "drt/dynamics/contacts.h"
#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

std::vector<RigidState> states_of(const RigidScene& s) {
    std::vector<RigidState> out;
    for (const RigidBody& b : s.bodies) out.push_back(b.start);
    return out;
}

std::vector<RigidState> collide(const RigidScene& scene) {
    const auto world = load_contact_world(scene);
    std::vector<RigidState> states = states_of(scene);
    const std::vector<Contact> contacts = find_contacts(*world, scene, states, 1e-6);
    EXPECT_EQ(contacts.size(), 1u);
    world->collide(states, contacts);
    return states;
}

// Two smooth balls, any offset and mass: the velocities along the line of centres are exchanged as in one dimension.
TEST(Collision, OfTwoBallsKeepsMomentumAndEnergy) {
    for (const double offset : {0.0, 1.0, 1.8})
        for (const double mass : {1.0, 1e3, 1e6}) {
            RigidScene scene{{ball({-std::sqrt(4 - offset * offset), offset, 0}, 1), ball({0, 0, 0}, 1, 1, mass)}, {}};
            for (RigidBody& b : scene.bodies) b.friction = 0;
            scene.bodies[0].start.velocity = {5, 0, 0};
            const std::vector<RigidState> before = states_of(scene), after = collide(scene);
            EXPECT_NEAR(kinetic_energy(scene, after) / kinetic_energy(scene, before), 1, 1e-12);
            EXPECT_LE(momentum_error(scene, before, after), 1e-12);
            const Vec3d n = normalize(scene.bodies[0].start.position);
            const double kick = 2 * mass / (1 + mass) * dot(before[0].velocity, n);
            EXPECT_LE(length(after[0].velocity - (before[0].velocity - n * kick)), 1e-12 * 5);
        }
}

TEST(Collision, FrictionMakesAFallingBallRoll) {
    RigidScene scene{{floor_body(), ball({0, 1, 0}, 0.8)}, {}};
    scene.bodies[1].start.velocity = {3, -10, 0};
    const RigidState s = collide(scene)[1];
    EXPECT_NEAR(s.velocity.y, 8, 1e-12);
    EXPECT_NEAR(s.velocity.x, 3 * 5.0 / 7, 1e-12);
    EXPECT_NEAR(s.spin.z, -3 * 5.0 / 7, 1e-12);
}

// All corners of a face push alike: the box does not begin to turn.
TEST(Collision, OfAFlatBoxIsEven) {
    RigidScene scene{{floor_body(), box({0, 1, 0}, {1, 1, 1}, 0.5)}, {}};
    scene.bodies[1].start.velocity = {1, -4, 0};
    const RigidState s = collide(scene)[1];
    EXPECT_LE(length(s.velocity - Vec3d{0, 2, 0}), 1e-10);
    EXPECT_LE(length(s.spin), 1e-10);
}

TEST(Nearest, IsTheDistanceOfTheSurfaces) {
    RigidScene scene{{ball({0, 0, 0}, 0, 0.5), box({0, 0, 0}, {1, 2, 3}, 0), floor_body()}, {}};
    const auto world = load_contact_world(scene);
    RigidState ball_at, box_at, floor_at;
    ball_at.position = {4, 6, 3};  // beyond an edge: 3-4-5
    const Nearest edge = nearest_bodies(*world, scene, 0, ball_at, 1, box_at);
    EXPECT_NEAR(edge.distance, 4.5, 1e-14);
    EXPECT_LE(length(edge.normal - Vec3d{0.6, 0.8, 0}), 1e-14);
    EXPECT_LE(length(edge.point - Vec3d{1, 2, 3}), 1e-14);
    const Nearest other_way = nearest_bodies(*world, scene, 1, box_at, 0, ball_at);
    EXPECT_EQ(other_way.distance, edge.distance);
    EXPECT_LE(length(other_way.normal + edge.normal), 1e-14);
    box_at.orientation = quat_from_axis_angle({0, 0, 1}, std::atan(1.0));  // stands on an edge
    box_at.position = {0, 5, 0};
    EXPECT_NEAR(nearest_bodies(*world, scene, 1, box_at, 2, floor_at).distance, 5 - 3 / std::sqrt(2.0), 1e-14);
}

}  // namespace
}  // namespace drt
