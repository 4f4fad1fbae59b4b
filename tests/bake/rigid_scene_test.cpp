// The simulated bodies of a scene, against closed forms and against the poses that are rendered.

#include "drt/bake/rigid_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "bake/bake_scenes.h"
#include "drt/dynamics/path.h"
#include "reference/motion.h"

namespace drt {
namespace {

using namespace test;
using Kind = PhysicsDesc::Kind;

RigidModel build(const std::vector<Body>& bodies) {
    SceneDesc s = scene_with_camera();
    s.bodies = bodies;
    return build_rigid_scene(input_over(s, 0, 1));
}

// A ball of radius 1 and mass 1 at the origin makes rigid units those of the scene.
Body unit_ball() {
    Body b = with_physics(sphere({0, 0, 0}, 1));
    b.physics->mass = 1;
    return b;
}

RigidBody fixed(const Shape& shape) { return build({unit_ball(), with_physics(shape, Kind::fixed)}).scene.bodies[1]; }

TEST(RigidScene, HoldsOnlyBodiesWithPhysics) {
    const RigidModel m = build({body("", sphere({5, 0, 0}, 1), "grey"), unit_ball()});
    ASSERT_EQ(m.scene.bodies.size(), 1u);
    EXPECT_EQ(m.scene.bodies[0].start.position, (Vec3d{0, 0, 0}));
}

TEST(RigidScene, HasEveryShape) {
    EXPECT_EQ(std::get<SphereCollider>(fixed(sphere({1, 2, 3}, 4)).collider).radius, 4);
    EXPECT_EQ(std::get<PlaneCollider>(fixed(Plane{{1, 2, 3}, {0, 0, 5}}).collider).normal, (Vec3d{0, 0, 1}));
    EXPECT_EQ(std::get<BoxCollider>(fixed(Box{{1, 2, 3}, {2, 4, 6}, {}}).collider).half, (Vec3d{1, 2, 3}));
    const auto cylinder = std::get<CylinderCollider>(fixed(Cylinder{{0, 0, 0}, {0, 6, 8}, 2, true}).collider);
    EXPECT_EQ(cylinder.radius, 2);
    EXPECT_EQ(cylinder.half_height, 5);
    const auto disc = std::get<DiscCollider>(fixed(Disc{{1, 2, 3}, {2, 0, 0}, 3}).collider);
    EXPECT_EQ(disc.normal, (Vec3d{1, 0, 0}));
    EXPECT_EQ(disc.radius, 3);
    using Vertices = std::vector<Vec3d>;
    EXPECT_EQ(std::get<PolygonCollider>(fixed(Triangle{{0, 0, 0}, {3, 0, 0}, {0, 6, 3}}).collider).vertices,
              (Vertices{{-1, -2, -1}, {2, -2, -1}, {-1, 4, 2}}));
    EXPECT_EQ(std::get<PolygonCollider>(fixed(Parallelogram{{0, 0, 0}, {2, 0, 0}, {2, 4, 0}}).collider).vertices,
              (Vertices{{-2, -2, 0}, {0, -2, 0}, {2, 2, 0}, {0, 2, 0}}));
    // Only the part of vertex2 - vertex0 across the first edge counts.
    EXPECT_EQ(std::get<PolygonCollider>(fixed(Rectangle{{0, 0, 0}, {2, 0, 0}, {7, 4, 0}}).collider).vertices,
              (Vertices{{-1, -2, 0}, {1, -2, 0}, {1, 2, 0}, {-1, 2, 0}}));
}

TEST(RigidScene, StandsWhereTheSceneSays) {
    const Box box{{1, 2, 3}, {2, 4, 6}, {0.5, 0.5, -0.5, 0.5}};
    EXPECT_EQ(fixed(box).start.position, (Vec3d{1, 2, 3}));
    EXPECT_EQ(fixed(box).start.orientation, box.orientation);
    EXPECT_EQ(fixed(Triangle{{0, 0, 0}, {3, 0, 0}, {0, 6, 3}}).start.position, (Vec3d{1, 2, 1}));
    const Vec3d from{1, 2, 3};
    for (const Vec3d axis : {Vec3d{0, 0, 1}, Vec3d{0, 0, -1}, Vec3d{1, 0, 0}, Vec3d{1e-9, 0, -1}, Vec3d{1e-3, 2e-3, -1},
                             Vec3d{-3, 1, 2}}) {
        const RigidBody b = fixed(Cylinder{from, from + axis, 1, true});
        EXPECT_LE(length(b.start.position - (from + axis * 0.5)), 1e-15);
        EXPECT_LE(length(rotate(b.start.orientation, Vec3d{0, 0, 1}) - normalize(axis)), 1e-15);
    }
}

TEST(RigidScene, IsInUnitsOfTheSmallestDynamicBody) {
    Body small = with_physics(Box{{10, 0, 0}, {3, 1, 2}, {}}), large = with_physics(sphere({0, 4, 0}, 2));
    small.physics->mass = 3;
    large.physics->density = 10;
    large.physics->velocity = {1, 2, 3};
    large.physics->angular_velocity_degrees = {0, 180, 0};
    large.physics->impulses = {{0.5, {6, 0, 0}, Vec3d{0, 1, 0}}, {0.25, {0, 3, 0}, {}}};
    large.physics->forces = {{0, 1, {0, 0, 9}}};
    const RigidModel m = build({small, large, with_physics(sphere({0, 0, 0}, 0.1), Kind::fixed)});
    EXPECT_EQ(m.units.length, 0.5);
    EXPECT_EQ(m.units.mass, 3);
    EXPECT_EQ(m.units.origin, (Vec3d{5, 2, 0}));
    EXPECT_EQ(m.scene.gravity, (Vec3d{0, -19.62, 0}));
    const RigidBody &a = m.scene.bodies[0], &b = m.scene.bodies[1];
    EXPECT_EQ(a.start.position, (Vec3d{10, -4, 0}));
    EXPECT_EQ(a.mass, 1);
    EXPECT_LE(length(a.inertia - Vec3d{1.0 + 4, 9.0 + 4, 9.0 + 1} * (4.0 / 12)), 1e-14);
    const double mass = 10 * 4 * pi<double> / 3 * 8 / 3;
    EXPECT_NEAR(b.mass, mass, 1e-13 * mass);
    EXPECT_NEAR(b.inertia.y, 0.4 * mass * 16, 1e-12 * mass);
    EXPECT_EQ(b.start.velocity, (Vec3d{2, 4, 6}));
    EXPECT_NEAR(b.start.spin.y, pi<double>, 1e-15);
    ASSERT_EQ(b.blows.size(), 2u);  // in the order of time
    EXPECT_EQ(b.blows[0].time, 0.25);
    EXPECT_EQ(b.blows[0].impulse, (Vec3d{0, 2, 0}));
    EXPECT_EQ(b.blows[0].at, (Vec3d{0, 0, 0}));
    EXPECT_EQ(b.blows[1].at, (Vec3d{0, 2, 0}));
    ASSERT_EQ(b.pushes.size(), 1u);
    EXPECT_EQ(b.pushes[0].force, (Vec3d{0, 0, 6}));
    EXPECT_EQ(std::get<SphereCollider>(m.scene.bodies[2].collider).radius, 0.2);
}

TEST(RigidScene, DropsEventsOutsideTheSimulatedTime) {
    Body ball = unit_ball();
    ball.physics->impulses = {{-0.1, {1, 0, 0}, {}}, {0, {2, 0, 0}, {}}, {1, {3, 0, 0}, {}}};
    ball.physics->forces = {{-2, -1, {1, 0, 0}}, {-1, 0.5, {2, 0, 0}}, {1, 2, {3, 0, 0}}};
    const RigidBody b = build({ball}).scene.bodies[0];
    ASSERT_EQ(b.blows.size(), 1u);
    EXPECT_EQ(b.blows[0].impulse.x, 2);
    ASSERT_EQ(b.pushes.size(), 1u);
    EXPECT_EQ(b.pushes[0].from, 0);
    EXPECT_EQ(b.pushes[0].until, 0.5);
}

// ---- kinematic bodies: where they are rendered ---------------------------------------------------------------------

Motion random_motion(std::mt19937& random, Motion::Interpolation interpolation) {
    std::uniform_real_distribution<double> u(-1, 1);
    const auto vector = [&] { return Vec3d{u(random), u(random), u(random)}; };
    Motion m;
    m.interpolation = interpolation;
    double time = -0.3;
    for (int i = 0; i < 6; ++i, time += 0.1 + 0.2 * (1 + u(random))) {
        const Vec3d axis = vector();
        m.keys.push_back(i > 0 && i % 3 == 2 ? turning_key(time, vector() * 5.0, axis, 700 * u(random))
                                             : key(time, vector() * 5.0, quat_from_axis_angle(normalize(axis), 2.5)));
    }
    return m;
}

TEST(RigidScene, MovesKinematicBodiesAsTheyAreRendered) {
    std::mt19937 random(1);
    for (int k = 0; k < 40; ++k) {
        Body moving = with_physics(Cylinder{{1, 2, 3}, {2, 4, 5}, 1, true}, Kind::kinematic);
        moving.motion = random_motion(random, k % 2 ? Motion::Interpolation::cubic : Motion::Interpolation::linear);
        Body ball = unit_ball();
        ball.shape = sphere({3, 0, 0}, 0.5);
        const RigidModel m = build({ball, moving});
        const RigidBody& b = m.scene.bodies[1];
        EXPECT_EQ(b.kind, RigidBody::Kind::kinematic);
        const Quatd frame = m.frames[1];
        for (int i = 0; i <= 1000; ++i) {
            const double t = i / 1000.0;
            const RigidState s = state_at(b, b.course, t);
            const reference::Pose pose = reference::pose_at(*moving.motion, t);
            ASSERT_LE(length(m.units.to_scene(s.position) - pose.position), 1e-6 * m.units.length + 1e-13);
            for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}})
                ASSERT_LE(length(rotate(s.orientation, axis) - rotate(pose.orientation, rotate(frame, axis))), 1e-12);
        }
        EXPECT_EQ(b.start.position, b.course.front().from.position);
    }
}

// Velocities change at the motion's keys and nowhere else; of a cubic motion not even there.
TEST(RigidScene, DoesNotStrikeWhatLiesOnABodyInCubicMotion) {
    std::mt19937 random(2);
    Body moving = with_physics(sphere({0, 9, 0}, 1), Kind::kinematic);
    moving.motion = random_motion(random, Motion::Interpolation::cubic);
    moving.motion->keys.back().time += 2;  // beyond what is simulated
    const RigidBody b = build({unit_ball(), moving}).scene.bodies[1];
    EXPECT_GT(b.course.size(), 20u);
    for (size_t i = 1; i < b.course.size(); ++i) {
        const Path &before = b.course[i - 1], &after = b.course[i];
        const RigidState s = state_at(b, before, after.begin);
        EXPECT_LE(length(s.position - after.from.position), 1e-12);
        EXPECT_LE(length(s.velocity - after.from.velocity), 1e-10);
    }
}

// Where doubles have no digits of that size left, parts do not become ever more.
TEST(RigidScene, FollowsEnormousCubicMotionAsFarAsDoublesDo) {
    Body moving = with_physics(sphere({0, 0, 0}, 1), Kind::kinematic);
    moving.motion =
        Motion{Motion::Interpolation::cubic,
               {key(0, {0, 0, 0}), key(0.25, {1e15, 0, 0}), key(0.5, {-1e15, 1e15, 0}), key(1, {0, 0, 1e15})}};
    Body ball = unit_ball();
    ball.shape = sphere({3, 0, 0}, 1e-9);
    const RigidModel m = build({ball, moving});
    const RigidBody& b = m.scene.bodies[1];
    EXPECT_LE(b.course.size(), 3u * 200000);
    for (int i = 0; i <= 100; ++i) {
        const double t = i / 100.0;
        const Vec3d at = m.units.to_scene(state_at(b, b.course, t).position);
        ASSERT_LE(length(at - reference::pose_at(*moving.motion, t).position), 1e-13 * 1e15) << t;
    }
}

TEST(RigidScene, LetsKinematicBodiesWithoutMotionStand) {
    const RigidModel m = build({unit_ball(), with_physics(sphere({0, 9, 0}, 1), Kind::kinematic)});
    EXPECT_EQ(m.scene.bodies[1].kind, RigidBody::Kind::fixed);
}

// The same scene in other units of length and mass, somewhere else.
TEST(RigidScene, IsTheSameInOtherUnits) {
    const double length_factor = 100, mass_factor = 1e-3;
    const auto make = [&](double l, double m, const Vec3d& shift) {
        SceneDesc s = scene_with_camera();
        s.units = l;
        Body ball = with_physics(sphere(shift + Vec3d{1, 2, 3} * l, 0.7 * l));
        ball.physics->mass = 3 * m;
        ball.physics->velocity = Vec3d{1, 2, 3} * l;
        ball.physics->impulses = {{0.5, Vec3d{1, 0, 1} * (l * m), Vec3d{0, 0.1, 0} * l}};
        Body box = with_physics(Box{shift + Vec3d{4, 2, 3} * l, Vec3d{1, 1, 2} * l, {}});
        box.physics->density = 2 * m / (l * l * l);
        s.bodies = {ball, box};
        return build_rigid_scene(input_over(s, 0, 1)).scene;
    };
    const RigidScene a = make(1, 1, {}), b = make(length_factor, mass_factor, {300, 0, 0});
    EXPECT_LE(length(a.gravity - b.gravity), 1e-13);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_LE(length(a.bodies[i].start.position - b.bodies[i].start.position), 1e-13);
        EXPECT_LE(length(a.bodies[i].start.velocity - b.bodies[i].start.velocity), 1e-13);
        EXPECT_LE(length(a.bodies[i].inertia - b.bodies[i].inertia), 1e-13);
        EXPECT_NEAR(a.bodies[i].mass, b.bodies[i].mass, 1e-13);
    }
    EXPECT_LE(length(a.bodies[0].blows[0].impulse - b.bodies[0].blows[0].impulse), 1e-13);
    EXPECT_LE(length(a.bodies[0].blows[0].at - b.bodies[0].blows[0].at), 1e-13);
}

}  // namespace
}  // namespace drt
