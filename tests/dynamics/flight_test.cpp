// Motion without contacts.

#include <gtest/gtest.h>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

Vec3d angular_momentum(const RigidBody& b, const RigidState& s) {
    const Vec3d w = rotate_back(s.orientation, s.spin);
    return rotate(s.orientation, Vec3d{b.inertia.x * w.x, b.inertia.y * w.y, b.inertia.z * w.z});
}

TEST(Flight, IsTheParabola) {
    RigidScene scene{{ball({1, 2, 3}, 0)}, {0, -9.81, 0}};
    scene.bodies[0].start.velocity = {4, 50, -1};
    scene.bodies[0].start.spin = {0, 30, 0};
    const Simulation r = simulate(scene, 0, 10, 1.0 / 24);
    EXPECT_EQ(r.contact_steps, 0);
    EXPECT_EQ(r.tracks[0].size(), 1u);  // one path, whatever the step
    for (const double t : {0.1, 3.0, 10.0}) {
        const RigidState s = state_at(scene.bodies[0], r.tracks[0], t);
        EXPECT_LE(length(s.position - Vec3d{1 + 4 * t, 2 + 50 * t - 4.905 * t * t, 3 - t}), 1e-12 * 500);
        const Vec3d x = rotate(s.orientation, Vec3d{1, 0, 0});
        EXPECT_LE(length(x - Vec3d{std::cos(30 * t), 0, -std::sin(30 * t)}), 1e-11);
    }
}

TEST(Flight, SlowDriftIsNotTakenForRest) {
    RigidScene scene{{floor_body(), ball({0, 5, 0}, 0)}, {0, 0, 0}};
    scene.bodies[1].start.velocity = {0.007, 0, 0};
    const Simulation r = simulate(scene, 0, 1000, 1.0 / 24);
    EXPECT_NEAR(state_at(scene.bodies[1], r.tracks[1], 1000).position.x, 7, 1e-12);
}

// Dzhanibekov's wing nut: rotation about the middle axis is unstable. Angular momentum and energy are what they were.
TEST(Flight, TumblingKeepsMomentumAndEnergy) {
    RigidScene scene{{box({0, 0, 0}, {1, 2, 3}, 0)}, {0, 0, 0}};
    scene.bodies[0].start.spin = {1e-3, 5, 2e-3};
    const Simulation r = simulate(scene, 0, 20, 1);
    const RigidBody& b = scene.bodies[0];
    const Vec3d momentum = angular_momentum(b, b.start);
    const double energy = kinetic_energy(scene, {b.start});
    double least = 1;
    for (double t = 0; t <= 20; t += 0.05) {
        const RigidState s = state_at(b, r.tracks[0], t);
        EXPECT_LE(length(angular_momentum(b, s) - momentum) / length(momentum), 1e-12);
        EXPECT_NEAR(kinetic_energy(scene, {s}) / energy, 1, 1e-8);
        least = std::min(least, rotate(s.orientation, Vec3d{0, 1, 0}).y);
    }
    EXPECT_LT(least, -0.9);  // it did turn over
}

}  // namespace
}  // namespace drt
