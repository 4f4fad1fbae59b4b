// Keyframes of a simulated body.

#include "drt/dynamics/keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

struct Bounce {
    RigidScene scene{{floor_body(), ball({0, 5, 0}, 0.6)}, {0, -9.81, 0}};
    Simulation result;
    Bounce() {
        scene.bodies[1].start.velocity = {3, 0, 0};
        scene.bodies[1].start.spin = {0, 20, 0};
        result = simulate(scene, 0, 6, 1.0 / 96);
    }
};

Vec3d interpolated(const std::vector<MotionKey>& keys, double t) {
    size_t i = 0;
    while (i + 2 < keys.size() && keys[i + 1].time < t) ++i;
    const double share = (t - keys[i].time) / (keys[i + 1].time - keys[i].time);
    return keys[i].position + (keys[i + 1].position - keys[i].position) * share;
}

TEST(Keys, StayWithinTheTolerance) {
    const Bounce b;
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        const auto keys = keys_of(b.scene.bodies[1], b.result.tracks[1], 0, 6, {tolerance, tolerance});
        double worst = 0;
        for (double t = 0; t <= 6; t += 1.0 / 1000)
            worst = std::max(
                worst, length(interpolated(keys, t) - state_at(b.scene.bodies[1], b.result.tracks[1], t).position));
        EXPECT_LE(worst, 1.05 * tolerance);
        EXPECT_GE(worst, 0.5 * tolerance);  // and are as few as that allows
    }
}

TEST(Keys, StandAtEveryBounce) {
    const Bounce b;
    const auto keys = keys_of(b.scene.bodies[1], b.result.tracks[1], 0, 6, {1e-2, 1e-2});
    const double first = std::sqrt(8 / 9.81);
    for (const double bounce : {first, first * (1 + 2 * 0.6), first * (1 + 2 * 0.6 + 2 * 0.36)}) {
        const auto at = std::find_if(keys.begin(), keys.end(),
                                     [&](const MotionKey& k) { return std::abs(k.time - bounce) < 1e-9; });
        ASSERT_NE(at, keys.end()) << bounce;
        EXPECT_NEAR(at->position.y, 1, 1e-9);
    }
    for (const MotionKey& k : keys) EXPECT_GE(k.position.y, 1 - 1e-9);  // never in the floor
}

// Of a body so fast that its places are coarser than the tolerance.
TEST(Keys, AreNotFinerThanNumbers) {
    RigidBody b = ball({0, 0, 0}, 0);
    b.start.velocity = {1e14, 3e13, 0};
    const Track track{{0, b.start, {0, -9.81, 0}, true}};
    EXPECT_LE(keys_of(b, track, 0, 5, {1e-3, 1e-3}).size(), 100u);
}

TEST(Keys, OfABodyAtRestAreOne) {
    const Bounce b;
    EXPECT_EQ(keys_of(b.scene.bodies[0], b.result.tracks[0], 0, 6, {}).size(), 1u);
}

// A ball at rest that is struck at 1 s has not turned until then.
TEST(Keys, DoNotTurnAheadOfABlow) {
    RigidScene scene{{ball({0, 0, 0}, 0)}, {}};
    scene.bodies[0].blows = {{1, {3, 0, 0}, {0, 1, 0}}};
    const Simulation r = simulate(scene, 0, 2, 1);
    const auto keys = keys_of(scene.bodies[0], r.tracks[0], 0, 2, {});
    ASSERT_EQ(keys.size(), 3u);
    EXPECT_EQ(keys[1].time, 1);
    EXPECT_FALSE(keys[1].turn.has_value());
    ASSERT_TRUE(keys[2].turn.has_value());
    EXPECT_NEAR(keys[2].turn->degrees, 3 / 0.4 * 180 / std::numbers::pi, 1e-9);
}

// Sliding to a halt takes a step every hundredth of a second, and a handful of keys.
TEST(Keys, AreFewWhereABodySlides) {
    RigidScene scene{{floor_body(), box({0, 1, 0}, {1, 1, 1}, 0)}, {0, -9.81, 0}};
    scene.bodies[1].start.velocity = {8, 0, 0};
    const Simulation r = simulate(scene, 0, 3, 1.0 / 960);
    EXPECT_GT(r.tracks[1].size(), 1000u);
    EXPECT_LE(keys_of(scene.bodies[1], r.tracks[1], 0, 3, {1e-3, 1e-3}).size(), 60u);
}

// A ball that spins ten times between two keys says so.
TEST(Keys, CountWholeRevolutions) {
    RigidScene scene{{ball({0, 0, 0}, 0)}, {}};
    scene.bodies[0].start.spin = {0, 20 * std::numbers::pi, 0};
    const Simulation r = simulate(scene, 0, 1.1, 1);
    const auto keys = keys_of(scene.bodies[0], r.tracks[0], 0, 1.1, {});
    ASSERT_EQ(keys.size(), 2u);
    ASSERT_TRUE(keys[1].turn.has_value());
    EXPECT_NEAR(keys[1].turn->degrees * keys[1].turn->axis.y, 3960, 1e-9);
}

}  // namespace
}  // namespace drt
