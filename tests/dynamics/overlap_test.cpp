// Bodies that are in each other come apart by as little as can be.

#include "drt/dynamics/overlap.h"

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

TEST(Overlap, LightBodiesGiveWay) {
    const RigidScene scene{{ball({0, 0, 0}, 0), ball({1.9, 0, 0}, 0, 1, 3)}, {}};
    std::vector<RigidState> states = states_of(scene);
    const auto world = load_contact_world(scene);
    const PushedApart r = push_apart(scene, find_contacts(*world, scene, states, 0), states, false);
    EXPECT_NEAR(r.deepest, 0.1, 1e-12);
    EXPECT_NEAR(states[0].position.x, -0.075, 1e-12);
    EXPECT_NEAR(states[1].position.x, 1.925, 1e-12);
}

// Sweeps never end this: the light boxes under the heavy one have to carry its way.
TEST(Overlap, UnderAHeavyBodyItGoesUp) {
    RigidScene scene = stack(6, 1e6);
    for (size_t i = 1; i < scene.bodies.size(); ++i) scene.bodies[i].start.position.y -= 0.01 * double(i);
    std::vector<RigidState> states = states_of(scene);
    const auto world = load_contact_world(scene);
    push_apart(scene, find_contacts(*world, scene, states, 1e-3), states, true);
    for (size_t i = 1; i < states.size(); ++i) EXPECT_NEAR(states[i].position.y, 2.0 * double(i) - 1, 1e-7) << i;
}

TEST(Overlap, ACornerComesOutByTurning) {
    RigidScene scene{{floor_body(), box({0, 0.99, 0}, {1, 1, 1}, 0)}, {}};
    scene.bodies[1].start.orientation = quat_from_axis_angle({0, 0, 1}, 1e-3);
    for (const bool turning : {false, true}) {
        std::vector<RigidState> states = states_of(scene);
        const auto world = load_contact_world(scene);
        push_apart(scene, find_contacts(*world, scene, states, 0.1), states, turning);
        EXPECT_EQ(states[1].orientation == scene.bodies[1].start.orientation, !turning);
        for (const Contact& c : find_contacts(*world, scene, states, 0.1))
            for (const ContactPoint& p : c.points()) EXPECT_GE(p.gap, -1e-5);
    }
}

}  // namespace
}  // namespace drt
