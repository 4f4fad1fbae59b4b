// Simulated motion as keyframes, against closed forms.

#include "drt/bake/bake.h"

#include <gtest/gtest.h>

#include "bake/bake_scenes.h"
#include "drt/formats/formats.h"
#include "reference/motion.h"
#include "support/process.h"

namespace drt {
namespace {

using namespace test;
using Kind = PhysicsDesc::Kind;

Diagnostics errors_of(const SceneDesc& s) {
    Diagnostics all = validate(s);
    std::erase_if(all, [](const Diagnostic& d) { return d.severity != Severity::error; });
    return all;
}

// Along the whole motion, between the keys as well.
TEST(Bake, FlightIsAParabolaWithinTheTolerance) {
    SceneDesc s = flying_ball();
    s.simulation.tolerance = 1e-3;
    const Baked baked = bake(s, 0);
    const Body& b = baked.scene.bodies[0];
    ASSERT_TRUE(b.motion);
    EXPECT_FALSE(b.physics);
    EXPECT_LE(b.motion->keys.size(), 90u);
    EXPECT_GE(b.motion->keys.size(), 65u);  // sag g (2.04 s / n)^2 / 8 = 1e-3: n = 71
    for (int i = 0; i <= 500; ++i) {
        const double t = 2.0 * i / 500;
        const reference::Pose pose = reference::pose_at(*b.motion, t);
        const Vec3d exact = Vec3d{1, 2, 3} + Vec3d{1, 5, -2} * t + Vec3d{0, -4.905, 0} * (t * t);
        ASSERT_LE(length(pose.position - exact), 1.006e-3);  // the keys look at 12 points of each sag
        const Quatd turn = quat_from_axis_angle({0, 1, 0}, pi<double> / 2 * t);
        ASSERT_LE(length(rotate(pose.orientation, Vec3d{1, 0, 0}) - rotate(turn, Vec3d{1, 0, 0})), 1e-9);
    }
    EXPECT_EQ(baked.report.dynamic_bodies, 1);
    EXPECT_EQ(baked.report.contact_steps, 0);
    EXPECT_EQ(baked.report.keys, int(b.motion->keys.size()));
    EXPECT_EQ(baked.report.tolerance, 1e-3);
    EXPECT_EQ(baked.report.trusted_until, baked.report.end);
}

// The described turn of a box is not part of its motion; its keys hold only what it turned since.
TEST(Bake, TurnsBodiesFromTheirDescribedPose) {
    SceneDesc s = scene_with_camera();
    s.gravity = Vec3d{};
    const Quatd described = normalize(Quatd{0.9, 0.2, -0.3, 0.4});
    s.bodies = {with_physics(Box{{0, 0, 0}, {1, 1, 1}, described}),
                with_physics(Cylinder{{3, 0, 0}, {3, 2, 0}, 1, true})};
    for (Body& b : s.bodies) b.physics->angular_velocity_degrees = {0, 400, 0};  // about the cylinder's axis
    const Baked baked = bake(s, 0);
    for (const Body& b : baked.scene.bodies)
        for (const double t : {0.0, 0.3, 1.1, 2.0}) {
            const Quatd turn = quat_from_axis_angle({0, 1, 0}, radians(400.0) * t);
            const reference::Pose pose = reference::pose_at(*b.motion, t);
            for (const Vec3d axis : {Vec3d{1, 0, 0}, Vec3d{0, 0, 1}})
                EXPECT_LE(length(rotate(pose.orientation, axis) - rotate(turn, axis)), 1e-8);
        }
}

TEST(Bake, LeavesNothingOfPhysics) {
    SceneDesc s = flying_ball();
    s.units = 2;
    s.gravity = {0, -1, 0};
    s.simulation.end = 1;
    Body door = with_physics(Box{{9, 9, 9}, {1, 2, 3}, {}}, Kind::kinematic);
    door.motion = Motion{{}, {key(0, {9, 9, 9}), key(1, {9, 9, 12})}};
    s.bodies.push_back(body("seen only", sphere({0, 0, 0}, 1), "grey"));
    s.bodies.push_back(door);
    s.bodies.push_back(with_physics(Plane{{0, -50, 0}}, Kind::fixed));
    const SceneDesc baked = bake(s, 0).scene;
    EXPECT_FALSE(has_physics(baked));
    EXPECT_EQ(baked.simulation, SimulationSettings{});
    EXPECT_FALSE(baked.gravity);
    EXPECT_EQ(baked.bodies[2].motion, door.motion);
    EXPECT_FALSE(baked.bodies[1].motion);
    EXPECT_FALSE(baked.bodies[3].motion);
    SceneDesc expected = s;  // all else is as it was
    expected.gravity.reset();
    expected.simulation = {};
    for (Body& b : expected.bodies) b.physics.reset();
    expected.bodies[0].motion = baked.bodies[0].motion;
    EXPECT_EQ(baked, expected);
    for (const Diagnostic& d : errors_of(baked)) ADD_FAILURE() << to_string(d);
}

TEST(Bake, GivesBodiesAtRestOneKeyAtTheirPlace) {
    SceneDesc s = scene_with_camera();
    const Vec3d place{0.1, 1.3, 0.7};
    s.bodies = {with_physics(sphere(place, 1.3)), with_physics(Plane{}, Kind::fixed),
                with_physics(Box{{30.1, 1, 0.2}, {1, 2, 3}, {}}), with_physics(sphere({3, 50, 0.123}, 0.3))};
    const Baked baked = bake(s, 0);
    ASSERT_EQ(baked.scene.bodies[0].motion->keys.size(), 1u);
    EXPECT_EQ(baked.scene.bodies[0].motion->keys[0].position, place);
    ASSERT_EQ(baked.scene.bodies[2].motion->keys.size(), 1u);
    EXPECT_EQ(baked.scene.bodies[2].motion->keys[0].position, (Vec3d{30.1, 1, 0.2}));
}

TEST(Bake, OfTimeThatHasNotBegunStands) {
    SceneDesc s = flying_ball();
    s.cameras[0].video_end.reset();
    s.simulation.start = 5;
    const Baked baked = bake(s, 2);
    ASSERT_EQ(baked.scene.bodies[0].motion->keys.size(), 1u);
    EXPECT_EQ(baked.scene.bodies[0].motion->keys[0].position, (Vec3d{1, 2, 3}));
}

TEST(Bake, StartsWhenTheSimulationDoes) {
    SceneDesc s = flying_ball();
    s.simulation.start = 1;
    const Motion m = *bake(s, 0).scene.bodies[0].motion;
    EXPECT_EQ(m.keys.front().time, 1);
    EXPECT_EQ(m.keys.front().position, (Vec3d{1, 2, 3}));
}

// A ball that flies towards the eye is seen larger and larger: what was exact enough at the start is not at the end.
TEST(Bake, LooksAtWhereBodiesAreSeen) {
    SceneDesc s = scene_with_camera();
    s.gravity = {0, 0, 0.1};
    s.bodies = {with_physics(sphere({0, 0, -100}, 0.5))};
    s.bodies[0].physics->velocity = {0, 0, 59};
    s.bodies[0].physics->angular_velocity_degrees = {1, 0, 0};
    s.cameras[0].shutter.duration = 0;
    s.cameras[0].video_end_inclusive = true;
    const BakeReport r = bake(s, 0).report;
    EXPECT_NEAR(r.tolerance, 0.1 * 0.02 * (20 - (-100 + 59 * 2 + 0.5 * 0.1 * 4) - 0.5), 1e-6);
}

TEST(Bake, KeepsToleranceWithinWhatTheBodiesAllow) {
    SceneDesc s = flying_ball();
    s.simulation.tolerance = 100;
    EXPECT_NEAR(bake(s, 0).report.tolerance, 0.1 * 0.5, 1e-15);
    s.simulation.tolerance = 1e-12;
    s.simulation.end = 0.01;
    EXPECT_NEAR(bake(s, 0).report.tolerance, 1e-6 * 0.5, 1e-15);
}

// So what a baked file renders is what the scene renders: the same values, the same bits.
TEST(Bake, WritesAsYamlToTheLastDigit) {
    SceneDesc s = flying_ball();
    s.lights.push_back(light("lamp", PointLight{{0, 9, 0}}, Color(1.0f)));
    s.bodies.push_back(with_physics(Plane{}, Kind::fixed));
    s.bodies.push_back(with_physics(Box{{1.1, 0.6, 2.9}, {1, 1, 1}, quat_from_axis_angle({0, 1, 0}, 0.3)}));
    for (Body& b : s.bodies) b.name = "body " + std::to_string(&b - s.bodies.data());
    const SceneDesc baked = bake(s, 0).scene;
    EXPECT_GT(baked.bodies[0].motion->keys.size(), 5u);
    EXPECT_GT(baked.bodies[2].motion->keys.size(), 2u);  // struck by the ball
    const TempFolder folder;
    const std::string file = folder.write("baked.yaml", write_yaml_scene(baked, folder.path().string()));
    EXPECT_EQ(read_yaml_scene(file).scene, baked);
}

TEST(Bake, IsTheSameEveryTime) {
    SceneDesc s = flying_ball();
    s.bodies.push_back(with_physics(Plane{}, Kind::fixed));
    s.bodies.push_back(with_physics(sphere({1.3, 0.7, 3.1}, 0.4)));
    for (Body& b : s.bodies) b.physics->restitution = 0.7;
    const BakeInput in = bake_input(s, 0);
    EXPECT_EQ(compute_motion(in), compute_motion(in));
}

// A ball of a centimetre, of a metre or of a kilometre drops, bounces off a box that it knocks over, and rolls: with
// gravity to scale, the same motion in units of the ball, though the files' numbers differ by 1e5.
TEST(Bake, MotionIsTheSameInAnyUnitsAndSizes) {
    const auto motion = [](double size) {
        SceneDesc s = scene_with_camera();
        s.gravity = Vec3d{0, -9.81, 0} * size;
        s.simulation.tolerance = 1e-3 * size;
        Body floor = with_physics(Plane{});
        floor.physics->kind = Kind::fixed;
        Body ball = with_physics(sphere({-3 * size, 3 * size, 0.1 * size}, size)),
             box = with_physics(Box{Vec3d{0, 2, 0} * size, Vec3d{1.5, 4, 2} * size, {}});
        ball.physics->velocity = Vec3d{3 * size, 0, 0};
        ball.physics->restitution = 0.6;
        ball.physics->density = 2 / (size * size * size);
        box.physics->density = 1 / (size * size * size);
        s.bodies = {floor, ball, box};
        return bake(s, 0);
    };
    const Baked metre = motion(1);
    for (const double size : {0.01, 1000.0}) {
        const Baked other = motion(size);
        EXPECT_NEAR(other.report.trusted_until, metre.report.trusted_until, 1e-3);
        for (const size_t body : {1u, 2u})
            for (double t = 0; t <= std::min(1.5, metre.report.trusted_until); t += 0.05) {
                const reference::Pose a = reference::pose_at(*metre.scene.bodies[body].motion, t),
                                      b = reference::pose_at(*other.scene.bodies[body].motion, t);
                ASSERT_LE(length(a.position - b.position / size), 4e-3) << size << " " << body << " at " << t;
            }
    }
    const double moved = length(metre.scene.bodies[2].motion->keys.back().position - Vec3d{0, 2, 0});
    EXPECT_GT(moved, 0.05);
    EXPECT_GT(metre.report.trusted_until, 0.7);
}

// What drt-bake and drt-render warn of, at the body's place.
TEST(Bake, ReportsABodyThatIsCrushed) {
    SceneDesc s = scene_with_camera();
    Body ball = with_physics(sphere({0, 1, 0}, 1)), wall = with_physics(Box{{3, 1, 0}, {1, 4, 4}, {}}),
         door = with_physics(Box{{-3, 1, 0}, {1, 4, 4}, {}}), floor = with_physics(Plane{});
    wall.physics->kind = floor.physics->kind = Kind::fixed;
    door.physics->kind = Kind::kinematic;
    door.motion = Motion{{}, {MotionKey{0, {-3, 1, 0}, {}, {}}, MotionKey{2, {3, 1, 0}, {}, {}}}};
    s.bodies = {floor, wall, door, ball};
    const Baked baked = bake(s, 2);
    ASSERT_FALSE(baked.report.notes.empty());
    const BakeNote& note = baked.report.notes[0];
    EXPECT_EQ(note.severity, Severity::warning);
    EXPECT_EQ(note.body, 3);
    EXPECT_NE(note.message.find("crushed"), std::string::npos) << note.message;
    EXPECT_NE(note.message.find("t = 1"), std::string::npos) << note.message;  // 3 between the faces, at 3 a second
    EXPECT_NEAR(baked.report.trusted_until, 1, 0.02);
}

}  // namespace
}  // namespace drt
