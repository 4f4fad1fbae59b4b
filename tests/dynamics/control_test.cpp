// How far a motion can be trusted.

#include "drt/dynamics/control.h"

#include <gtest/gtest.h>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

TEST(Control, AFlightNeedsOneRun) {
    const RigidScene scene{{floor_body(), ball({0, 500, 0}, 0)}, {0, -9.81, 0}};
    const Controlled r = simulate_controlled(scene, 0, 5, 1e-3);
    EXPECT_EQ(r.runs, 1);
    EXPECT_EQ(r.simulation.contact_steps, 0);
    EXPECT_EQ(r.trusted_until, 5);
}

TEST(Control, HalvesTheStepUntilItDoesNotMatter) {
    RigidScene scene{{floor_body(), ball({0, 1, 0}, 0)}, {0, -9.81, 0}};
    scene.bodies[1].start.velocity = {5, 0, 0};
    const double rolls_from = 2 * 5 / (7 * 0.5 * 9.81);
    const double exact = 5 * rolls_from - 0.25 * 9.81 * rolls_from * rolls_from + 25.0 / 7 * (2 - rolls_from);
    for (const double tolerance : {1e-3, 1e-6}) {
        const Controlled r = simulate_controlled(scene, 0, 2, tolerance);
        EXPECT_EQ(r.trusted_until, 2);
        EXPECT_NEAR(state_at(scene.bodies[1], r.simulation.tracks[1], 2).position.x, exact, 2 * tolerance);
        EXPECT_TRUE(r.audit.passes());
        // Its two halvings changed less, and the one before them more (or it is the first).
        const auto change = [&](double step) {
            return compare_motions(scene, simulate(scene, 0, 2, step).tracks, simulate(scene, 0, 2, step / 2).tracks, 0,
                                   2, 1e9)
                .largest;
        };
        EXPECT_LE(change(2 * r.step), tolerance);
        EXPECT_LE(change(4 * r.step), tolerance);
        EXPECT_NEAR(r.error, change(2 * r.step), 1e-12);
        EXPECT_TRUE(r.runs == 4 || change(8 * r.step) > tolerance);
    }
}

TEST(Control, NotANumberAgreesWithNothing) {
    const RigidScene scene{{ball({0, 0, 0}, 0)}, {}};
    Path p{0, scene.bodies[0].start, {}, true};
    p.from.velocity.x = std::nan("");
    const std::vector<Track> tracks{{p}};
    EXPECT_EQ(compare_motions(scene, tracks, tracks, 0, 1, 1e-3).from, 0);
}

// Errors of the ninth digit grow by some hundred at every collision: nobody can foretell this for long.
TEST(Control, ABreakIsTrustedForAWhile) {
    RigidScene scene = billiard_break(1e-2);
    for (const double side : {-1.0, 1.0}) {
        scene.bodies.push_back(box({0, 1, 25 * side}, {46, 2, 1}, 0.8));
        scene.bodies.push_back(box({45 * side, 1, 0}, {1, 2, 24}, 0.8));
    }
    for (size_t i = scene.bodies.size() - 4; i < scene.bodies.size(); ++i)
        scene.bodies[i].kind = RigidBody::Kind::fixed;
    const Controlled r = simulate_controlled(scene, 0, 3, 1e-4);
    EXPECT_LT(r.trusted_until, 3);
    EXPECT_GT(r.trusted_until, 0.09);  // when the cue ball arrives
    EXPECT_TRUE(r.audit.passes());
    // A step that it did not try agrees until about then, and no longer.
    const Difference finer =
        compare_motions(scene, r.simulation.tracks, simulate(scene, 0, 3, r.step / 2).tracks, 0, 3, 1e-2);
    EXPECT_GE(finer.from, r.trusted_until);
    EXPECT_LT(finer.from, 3);
}

}  // namespace
}  // namespace drt
