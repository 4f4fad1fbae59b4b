// Blows, pushes and bodies that follow a course.

#include <gtest/gtest.h>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

// The change of velocity is the impulse by the mass, whatever the step, on a body in flight or on the ground.
TEST(Events, ABlowChangesTheMomentumAtOnce) {
    for (const double step : {1.0 / 24, 1.0 / 1000}) {
        RigidScene scene{{floor_body(), ball({0, 4, 0}, 0, 4, 268.08)}, {0, -9.81, 0}};
        scene.bodies[1].blows = {{0.1, {5000, 0, 0}, {0, 0, 0}}};
        const Simulation r = simulate(scene, 0, 1, step);
        const double after = state_at(scene.bodies[1], r.tracks[1], 0.1).velocity.x;
        EXPECT_NEAR(after, 5000 / 268.08, 0.5 * 9.81 * step);  // friction's work of a step
        scene.gravity = {};
        const Simulation flight = simulate(scene, 0, 1, step);
        EXPECT_NEAR(state_at(scene.bodies[1], flight.tracks[1], 0.1).velocity.x, 5000 / 268.08, 1e-12);
        EXPECT_NEAR(state_at(scene.bodies[1], flight.tracks[1], 1).position.x, 0.9 * 5000 / 268.08, 1e-11);
    }
}

// Off the centre it also turns the body: J r = I w.
TEST(Events, ABlowOffTheCentreTurns) {
    RigidScene scene{{ball({0, 0, 0}, 0)}, {}};
    scene.bodies[0].blows = {{0, {1, 0, 0}, {0, 0.7, 0}}};
    const Simulation r = simulate(scene, 0, 1, 0.1);
    const RigidState s = state_at(scene.bodies[0], r.tracks[0], 0.5);
    EXPECT_NEAR(s.velocity.x, 1, 1e-15);
    EXPECT_NEAR(s.spin.z, -0.7 / 0.4, 1e-14);
}

TEST(Events, APushAcceleratesWhileItLasts) {
    RigidScene scene{{ball({0, 0, 0}, 0, 1, 2)}, {}};
    scene.bodies[0].pushes = {{1, 3, {4, 0, 0}}, {2, 4, {0, 2, 0}}};
    const Simulation r = simulate(scene, 0, 10, 0.1);
    const RigidState s = state_at(scene.bodies[0], r.tracks[0], 10);
    EXPECT_NEAR(s.velocity.x, 4, 1e-14);
    EXPECT_NEAR(s.velocity.y, 2, 1e-14);
    EXPECT_NEAR(s.position.x, 4 + 4 * 7, 1e-12);
    EXPECT_NEAR(s.position.y, 2 + 2 * 6, 1e-12);
}

// A racket at 4 units a second sends a resting ball off at twice its speed.
TEST(Events, AKinematicBodyPushesOthers) {
    RigidBody racket = box({-5, 1, 0}, {0.1, 1, 1}, 1);
    racket.kind = RigidBody::Kind::kinematic;
    racket.course.assign(3, Path{0, racket.start, {}, false});
    racket.course[1].begin = 1;
    racket.course[1].from.velocity = {4, 0, 0};
    racket.course[2].begin = 2;
    racket.course[2].from.position.x = -1;
    RigidScene scene{{floor_body(), racket, ball({-2, 1, 0}, 1)}, {0, -9.81, 0}};
    scene.bodies[2].friction = 0;
    const Simulation r = simulate(scene, 0, 3, 1.0 / 96);
    const RigidState s = state_at(scene.bodies[2], r.tracks[2], 3);
    const double hit = 1 + 1.9 / 4;
    EXPECT_NEAR(s.velocity.x, 8, 1e-12);
    EXPECT_NEAR(s.position.x, -2 + 8 * (3 - hit), 1e-9);
    EXPECT_NEAR(state_at(scene.bodies[1], r.tracks[1], 1.5).position.x, -3, 1e-14);
}

TEST(Events, ALiftCarriesWhatStandsOnIt) {
    RigidBody lift = box({0, -1, 0}, {2, 1, 2}, 0);
    lift.kind = RigidBody::Kind::kinematic;
    lift.course = {{0, lift.start, {}, false}};
    lift.course[0].from.velocity = {0, 0.5, 0};
    const RigidScene scene{{lift, box({0, 1, 0}, {1, 1, 1}, 0)}, {0, -9.81, 0}};
    const Simulation r = simulate(scene, 0, 4, 1.0 / 96);
    const RigidState s = state_at(scene.bodies[1], r.tracks[1], 4);
    EXPECT_LE(length(s.position - Vec3d{0, 3, 0}), 1e-6);
}

// At the instant at which a lift turns round, what stands on it leaves it at the speed that it had.
TEST(Events, ALiftThatTurnsRoundThrowsWhatStandsOnIt) {
    for (const double step : {1.0 / 96, 1.0 / 192, 1.0 / 768}) {
        RigidBody lift = box({0, -1, 0}, {2, 1, 2}, 0);
        lift.kind = RigidBody::Kind::kinematic;
        lift.course.assign(2, Path{0, lift.start, {}, false});
        lift.course[0].from.velocity = {0, 2, 0};
        lift.course[1].begin = 1;
        lift.course[1].from.position.y += 2;
        lift.course[1].from.velocity = {0, -1, 0};
        const RigidScene scene{{lift, box({0, 1, 0}, {1, 1, 1}, 0)}, {0, -9.81, 0}};
        const Simulation r = simulate(scene, 0, 1.5, step);
        const RigidState s = state_at(scene.bodies[1], r.tracks[1], 1.5);
        EXPECT_NEAR(s.position.y, 3 + 2 * 0.5 - 0.5 * 9.81 * 0.25, 1e-6) << step;
    }
}

}  // namespace
}  // namespace drt
