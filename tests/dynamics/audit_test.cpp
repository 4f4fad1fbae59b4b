// The audit accepts right motions and rejects wrong ones; Bullet's own stepping is the wrong one that converges.

#include "drt/dynamics/audit.h"

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include "dynamics/rigid_scenes.h"

namespace drt {
namespace {

using namespace test;

RigidScene bouncing_ball(double restitution) { return {{floor_body(), ball({0, 6, 0}, restitution)}, {0, -9.81, 0}}; }

// A ball on a floor as Bullet steps it, with the settings it comes with. Its steps (v += g h, x += v h) are parabolas
// when the velocity is read half a step later.
std::vector<Track> bullets_own(const RigidScene& scene, double end, double step) {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
    world.setGravity({scene.gravity.x, scene.gravity.y, scene.gravity.z});
    const RigidBody& b = scene.bodies[1];
    btStaticPlaneShape floor({0, 1, 0}, 0);
    btSphereShape sphere(1);
    btRigidBody floor_body(0, nullptr, &floor);
    btRigidBody body(b.mass, nullptr, &sphere, {b.inertia.x, b.inertia.y, b.inertia.z});
    body.setWorldTransform(btTransform(btQuaternion::getIdentity(), {0, b.start.position.y, 0}));
    floor_body.setRestitution(1);  // Bullet multiplies
    body.setRestitution(b.restitution);
    world.addRigidBody(&floor_body);
    world.addRigidBody(&body);
    std::vector<Track> tracks{{Path{0, scene.bodies[0].start, {}, false}}, {}};
    for (int k = 0; k * step < end; ++k) {
        RigidState s = b.start;
        s.position.y = body.getWorldTransform().getOrigin().y();
        s.velocity = {0, body.getLinearVelocity().y(), 0};
        s.velocity += scene.gravity * (0.5 * step);
        tracks[1].push_back({k * step, s, scene.gravity, true});
        world.stepSimulation(step, 0, step);
    }
    world.removeRigidBody(&body);
    world.removeRigidBody(&floor_body);
    return tracks;
}

TEST(Audit, AcceptsExactBounces) {
    for (const double e : {1.0, 0.8, 0.5, 0.1}) {
        const RigidScene scene = bouncing_ball(e);
        const Simulation r = simulate(scene, 0, 8, 1.0 / 96);
        const Audit a = audit(scene, r.tracks, 8);
        EXPECT_TRUE(a.passes());
        EXPECT_GE(a.bounces, 1);
        EXPECT_LE(a.energy_rise, 1e-9);
        EXPECT_LE(a.restitution_error, 1e-9);
    }
}

// At all these steps the motion hardly changes from one to the next, and is wrong: the bounce dies.
TEST(Audit, RejectsBulletsDefaultsHoweverSmallTheStep) {
    for (const double step : {1.0 / 240, 1.0 / 960, 1.0 / 3840})
        for (const double e : {1.0, 0.6}) {
            const RigidScene scene = bouncing_ball(e);
            const Audit a = audit(scene, bullets_own(scene, 8, step), 8);
            EXPECT_GE(a.bounces, 1) << step;
            EXPECT_FALSE(a.passes()) << "step 1/" << 1 / step << ", e " << e;
        }
}

// Without gravity nothing says how long a bounce may take: balls that meet others a moment later are not judged.
TEST(Audit, AcceptsAGas) {
    RigidScene scene{{}, {}};
    for (int i = 0; i < 12; ++i) {
        scene.bodies.push_back(ball({i % 3 * 2.6 - 2.6, i / 3 % 2 * 2.6 - 1.3, i / 6 * 2.6 - 1.3}, 1));
        scene.bodies.back().friction = 0;
        scene.bodies.back().start.velocity = Vec3d{1.0 + i % 5, i % 4 - 2.0, i % 7 - 3.0} * 3;
    }
    for (int side = 0; side < 6; ++side) {
        const double way = side % 2 ? 1 : -1;
        RigidBody wall = floor_body(1);
        const Vec3d normal{side / 2 == 0 ? way : 0, side / 2 == 1 ? way : 0, side / 2 == 2 ? way : 0};
        wall.collider = PlaneCollider{normal};
        wall.friction = 0;
        wall.start.position = normal * -4.0;
        scene.bodies.push_back(wall);
    }
    const Simulation r = simulate(scene, 0, 10, 1.0 / 96);
    const Audit a = audit(scene, r.tracks, 10);
    EXPECT_GT(r.impacts.size(), 100u);
    EXPECT_GT(a.bounces, 10);
    EXPECT_LE(a.restitution_error, 1e-9);
    EXPECT_LE(a.energy_rise, 1e-9);
}

TEST(Audit, RejectsAGainOfEnergy) {
    const RigidScene scene = bouncing_ball(0.8);
    Simulation r = simulate(scene, 0, 3, 1.0 / 96);
    r.tracks[1][1].from.velocity *= 1.3;  // a bounce with e = 1.04
    const Audit a = audit(scene, r.tracks, 3);
    EXPECT_FALSE(a.passes());
    EXPECT_GE(a.energy_rise, 0.05);
}

}  // namespace
}  // namespace drt
