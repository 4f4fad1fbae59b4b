// What cannot be simulated ends, and is told: with the body, the time and its speed.

#include <gtest/gtest.h>

#include <cmath>

#include "drt/dynamics/control.h"
#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

bool is_finite(const RigidState& s) {
    return std::isfinite(length(s.position)) && std::isfinite(length(s.velocity)) && std::isfinite(length(s.spin));
}

// A door closes on a ball in front of a wall.
RigidScene crush(double restitution) {
    RigidBody door = box({-5, 1, 0}, {0.5, 2, 2}, restitution), wall = box({5, 1, 0}, {0.5, 2, 2}, restitution);
    wall.kind = RigidBody::Kind::fixed;
    door.kind = RigidBody::Kind::kinematic;
    door.course = {{0, door.start, {}, false}};
    door.course[0].from.velocity = {4, 0, 0};
    return {{floor_body(restitution), wall, door, ball({0, 1, 0}, restitution)}, {0, -9.81, 0}};
}

TEST(Unresolved, ACrushedBallIsReported) {
    for (const double restitution : {0.0, 0.5}) {
        const RigidScene scene = crush(restitution);
        const Simulation r = simulate(scene, 0, 4, 1.0 / 96);
        const double closed = (9 - 2) / 4.0;  // between the faces there is no room for the ball from here on
        const bool told = r.given_up.time < 4 || r.deepest_overlap > 0.01;
        EXPECT_TRUE(told) << restitution;
        const Trouble& t = r.given_up.time < 4 ? r.given_up : r.overlapped;
        EXPECT_EQ(t.body, 3) << restitution;
        EXPECT_GE(t.time, closed - 1e-3) << restitution;
        for (double time = 0; time < 4; time += 0.1)
            EXPECT_TRUE(is_finite(state_at(scene.bodies[3], r.tracks[3], time))) << restitution << " " << time;
    }
}

TEST(Unresolved, EnormousSpeedsStayNumbers) {
    for (const double speed : {1e8, 1e12, 1e100, 1e200}) {
        RigidBody left = box({-20, 0, 0}, {1, 20, 20}, 1), right = box({20, 0, 0}, {1, 20, 20}, 1);
        left.kind = right.kind = RigidBody::Kind::fixed;
        RigidScene scene{{left, right, ball({0, 0, 0}, 1)}, {}};
        scene.bodies[2].start.velocity = {speed, 0.1 * speed, 0};
        const double end = 500 / speed;
        const Controlled r = simulate_controlled(scene, 0, end, 1e-3);
        for (const double share : {0.1, 0.5, 1.0})
            EXPECT_TRUE(is_finite(state_at(scene.bodies[2], r.simulation.tracks[2], share * end))) << speed;
        EXPECT_TRUE(r.simulation.given_up.time < end || r.simulation.impacts.size() >= 12u) << speed;
    }
}

TEST(Unresolved, ATopThatTurnsForEverIsGivenUp) {
    RigidScene scene{{box({0, 0, 0}, {1, 2, 3}, 0)}, {}};
    scene.bodies[0].start.spin = {1e8, 1e7, 0};
    const Simulation r = simulate(scene, 0, 10, 1.0 / 96);
    EXPECT_LT(r.given_up.time, 10);
    EXPECT_EQ(r.given_up.body, 0);
    EXPECT_EQ(length(state_at(scene.bodies[0], r.tracks[0], 10).spin), 0);
}

TEST(Unresolved, AStartInsideAnotherIsReported) {
    const RigidScene scene{{floor_body(), ball({3, 1, 0}, 0), ball({0, 0.8, 0}, 0)}, {0, -9.81, 0}};
    const Simulation r = simulate(scene, 0, 1, 1.0 / 96);
    EXPECT_NEAR(r.deepest_start, 0.2, 1e-12);
    EXPECT_EQ(r.started_in_another.body, 2);
    EXPECT_EQ(r.started_in_another.time, 0);
    EXPECT_LE(r.deepest_overlap, 1e-9);
}

}  // namespace
}  // namespace drt
