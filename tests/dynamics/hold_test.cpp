// Impulses of lasting contacts, against equilibria with closed forms.

#include "drt/dynamics/hold.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "drt/dynamics/contacts.h"
#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

constexpr double g = 9.81;

// The numerics of stiff scenes: Bullet's solvers let the stack collapse from a ratio of 100 or 10000 on.
TEST(Hold, AStackUnderAHeavyBodyStands) {
    for (const double heavy : {1.0, 1e2, 1e4, 1e5}) {
        const RigidScene scene = stack(10, heavy);
        const Simulation r = simulate(scene, 0, 60, 1.0 / 96);
        for (size_t i = 1; i < scene.bodies.size(); ++i) {
            const RigidState s = state_at(scene.bodies[i], r.tracks[i], 60);
            EXPECT_LE(length(s.position - scene.bodies[i].start.position), 1e-6) << heavy << ": body " << i;
        }
    }
}

// What the floor carries is all there is above it, and each body what is above it.
TEST(Hold, ForcesCarryTheWeights) {
    const RigidScene scene = stack(5, 1000);
    std::vector<RigidState> states;
    for (const RigidBody& b : scene.bodies) states.push_back(b.start);
    const auto world = load_contact_world(scene);
    std::vector<Contact> contacts = find_contacts(*world, scene, states, 1e-6);
    ASSERT_EQ(contacts.size(), 5u);
    constexpr double h = 0.01;
    for (size_t i = 1; i < states.size(); ++i) states[i].velocity.y -= g * h;
    EXPECT_LE(hold(scene, states, contacts, h, h), 1e-7 * g * h);
    for (const Contact& c : contacts) {
        Vec3d force;
        for (const ContactPoint& p : c.points()) force += p.force;
        double above = 0;
        for (size_t i = size_t(std::max(c.a, c.b)); i < scene.bodies.size(); ++i) above += scene.bodies[i].mass * g;
        EXPECT_NEAR(std::abs(force.y) / above, 1, 1e-6) << c.a << " and " << c.b;
    }
}

RigidScene slope(const RigidBody& body, double degrees) {
    RigidScene scene{{floor_body(), body}, {}};
    const double angle = degrees * pi<double> / 180;
    scene.gravity = Vec3d{std::sin(angle), -std::cos(angle), 0} * g;
    return scene;
}

TEST(Hold, ABlockOnASlopeSticksOrSlides) {
    for (const double degrees : {20.0, 26.0, 27.0, 40.0}) {  // tan 26.565 = the friction
        const RigidScene scene = slope(box({0, 1, 0}, {1, 1, 1}, 0), degrees);
        const Simulation r = simulate(scene, 0, 1, 1.0 / 96);
        const double angle = degrees * pi<double> / 180;
        const double acceleration = std::max(0.0, g * (std::sin(angle) - 0.5 * std::cos(angle)));
        const RigidState s = state_at(scene.bodies[1], r.tracks[1], 1);
        EXPECT_NEAR(s.position.x, 0.5 * acceleration, 2e-3 * std::max(0.1, acceleration)) << degrees;
        EXPECT_NEAR(s.position.y, 1, 1e-6);
    }
}

TEST(Hold, ABallRollsDownASlope) {
    const RigidScene scene = slope(ball({0, 1, 0}, 0), 20);
    const Simulation r = simulate(scene, 0, 2, 1.0 / 96);
    const double acceleration = 5.0 / 7 * g * std::sin(20 * pi<double> / 180);
    const RigidState s = state_at(scene.bodies[1], r.tracks[1], 2);
    EXPECT_NEAR(s.velocity.x, 2 * acceleration, 1e-2 * acceleration);
    EXPECT_NEAR(s.position.x, 2 * acceleration, 1e-9);
    EXPECT_NEAR(s.spin.z, -s.velocity.x, 1e-9);
}

TEST(Hold, RollingFrictionStopsABall) {
    RigidScene scene{{floor_body(), ball({0, 1, 0}, 0)}, {0, -g, 0}};
    scene.bodies[1].rolling_friction = 0.1;
    scene.bodies[1].start.velocity = {5, 0, 0};
    scene.bodies[1].start.spin = {0, 0, -5};
    const double way = 12.5 / (0.1 * g * 5 / 7);
    for (const double step : {1.0 / 24, 1.0 / 96}) {
        const Simulation r = simulate(scene, 0, 20, step);
        EXPECT_NEAR(state_at(scene.bodies[1], r.tracks[1], 20).position.x, way, 0.1 * step) << step;
    }
}

}  // namespace
}  // namespace drt
