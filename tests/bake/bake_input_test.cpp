// What a bake depends on, and for how long it goes on.

#include "drt/bake/bake_input.h"

#include <gtest/gtest.h>

#include <functional>

#include "bake/bake_scenes.h"

namespace drt {
namespace {

using namespace test;
using Change = std::function<void(SceneDesc&)>;

// Everything that an input can hold is there.
SceneDesc rich_scene() {
    SceneDesc s = flying_ball();
    PhysicsDesc& p = *s.bodies[0].physics;
    p.mass = 2;
    p.impulses = {{0.5, {1, 0, 0}, Vec3d{0, 0.1, 0}}};
    p.forces = {{0.5, 1, {0, 1, 0}}};
    Body door = with_physics(Box{{0, 0, 0}, {1, 2, 3}, {}}, PhysicsDesc::Kind::kinematic);
    door.motion = Motion{{}, {key(0, {0, 0, 0}), key(1, {1, 0, 0})}};
    s.bodies.push_back(door);
    s.bodies.push_back(with_physics(Plane{}, PhysicsDesc::Kind::fixed));
    s.bodies.push_back(body("seen only", sphere({0, 0, 0}, 1), "grey"));
    s.cameras[0].positions = {{0, 0, 20}, {0, 5, 20}};
    return s;
}

std::string text_of(const SceneDesc& s) { return input_text(bake_input(s, 0)); }

TEST(BakeInput, KnowsWhatMatters) {
    const std::vector<std::pair<std::string, Change>> changes{
        {"mass", [](SceneDesc& s) { s.bodies[0].physics->mass = 3; }},
        {"density", [](SceneDesc& s) { s.bodies[0].physics->mass.reset(), s.bodies[0].physics->density = 3; }},
        {"friction", [](SceneDesc& s) { s.bodies[0].physics->friction = 0.4; }},
        {"rolling friction", [](SceneDesc& s) { s.bodies[2].physics->rolling_friction = 0.4; }},
        {"restitution", [](SceneDesc& s) { s.bodies[2].physics->restitution = 0.4; }},
        {"velocity", [](SceneDesc& s) { s.bodies[0].physics->velocity.x += 1e-15; }},
        {"spin", [](SceneDesc& s) { s.bodies[0].physics->angular_velocity_degrees.x = 1; }},
        {"impulse", [](SceneDesc& s) { s.bodies[0].physics->impulses[0].impulse.x = 2; }},
        {"impulse time", [](SceneDesc& s) { s.bodies[0].physics->impulses[0].time = 0.6; }},
        {"impulse at", [](SceneDesc& s) { s.bodies[0].physics->impulses[0].at.reset(); }},
        {"force", [](SceneDesc& s) { s.bodies[0].physics->forces[0].force.x = 2; }},
        {"force until", [](SceneDesc& s) { s.bodies[0].physics->forces[0].until = 2; }},
        {"kind", [](SceneDesc& s) { s.bodies[1].physics->kind = PhysicsDesc::Kind::fixed; }},
        {"no physics", [](SceneDesc& s) { s.bodies[2].physics.reset(); }},
        {"radius", [](SceneDesc& s) { std::get<Sphere>(s.bodies[0].shape).radius = 0.6; }},
        {"place", [](SceneDesc& s) { std::get<Plane>(s.bodies[2].shape).position.y = -1; }},
        {"motion", [](SceneDesc& s) { s.bodies[1].motion->keys[1].time = 2; }},
        {"order", [](SceneDesc& s) { std::swap(s.bodies[1], s.bodies[2]); }},
        {"gravity",
         [](SceneDesc& s) {
             s.gravity = {0, -1, 0};
         }},
        {"units", [](SceneDesc& s) { s.units = 100; }},
        {"start", [](SceneDesc& s) { s.simulation.start = 0.1; }},
        {"end", [](SceneDesc& s) { s.simulation.end = 1; }},
        {"tolerance", [](SceneDesc& s) { s.simulation.tolerance = 1e-3; }},
        {"tolerance in pixels", [](SceneDesc& s) { s.simulation.tolerance_pixels = 1; }},
        {"resolution", [](SceneDesc& s) { s.render.width = 200; }},
        {"eye", [](SceneDesc& s) { s.cameras[0].positions[1].y = 6; }},
        {"moving eye",
         [](SceneDesc& s) {
             s.cameras[0].motion = Motion{{}, {key(0, {1, 1, 1})}};
         }},
        {"angle of view", [](SceneDesc& s) { s.cameras[0].fov_degrees_end = 30; }},
        {"zoom", [](SceneDesc& s) { s.cameras[0].zoom = Camera::Zoom::image_width; }},
        {"video", [](SceneDesc& s) { s.cameras[0].video_end = 3; }},
        {"end of the video", [](SceneDesc& s) { s.cameras[0].video_end_inclusive = true; }},
        {"slow motion", [](SceneDesc& s) { s.cameras[0].time_end = 1; }},
        {"exposure beyond the end", [](SceneDesc& s) { s.cameras[0].shutter.duration = 1; }},
    };
    const std::string text = text_of(rich_scene());
    for (const auto& [what, change] : changes) {
        SceneDesc s = rich_scene();
        change(s);
        EXPECT_NE(text_of(s), text) << what;
    }
}

TEST(BakeInput, IgnoresWhatDoesNotMatter) {
    const std::vector<std::pair<std::string, Change>> changes{
        {"colour", [](SceneDesc& s) { s.materials[0].diffuse = Color(0.1f); }},
        {"names", [](SceneDesc& s) { s.bodies[0].name = s.cameras[0].name = s.materials[0].name = "other"; }},
        {"material", [](SceneDesc& s) { s.bodies[0].material = "other"; }},
        {"turn of a ball's texture",
         [](SceneDesc& s) {
             std::get<Sphere>(s.bodies[0].shape).meridian = {1, 0, 0};
         }},
        {"other bodies", [](SceneDesc& s) { s.bodies[3].shape = Plane{}; }},
        {"order of other bodies", [](SceneDesc& s) { std::swap(s.bodies[2], s.bodies[3]); }},
        {"lights", [](SceneDesc& s) { s.lights.push_back({}); }},
        {"background", [](SceneDesc& s) { s.background = Color(1.0f); }},
        {"samples", [](SceneDesc& s) { s.render.spp = 1, s.render.seed = 7, s.render.max_depth = 0; }},
        {"height", [](SceneDesc& s) { s.render.height = 10; }},
        {"where the camera looks",
         [](SceneDesc& s) {
             s.cameras[0].targets = {{1, 1, 1}};
         }},
        {"lens", [](SceneDesc& s) { s.cameras[0].lens.aperture_radius = 1; }},
        {"gravity as it is anyway",
         [](SceneDesc& s) {
             s.gravity = {0, -9.81, 0};
         }},
        {"where it was written",
         [](SceneDesc& s) {
             s.sources.places["bodies[0]"] = {"a.yaml", 1, 1};
         }},
    };
    const std::string text = text_of(rich_scene());
    for (const auto& [what, change] : changes) {
        SceneDesc s = rich_scene();
        change(s);
        EXPECT_EQ(text_of(s), text) << what;
    }
}

TEST(BakeInput, WithAToleranceInSceneUnitsDoesNotLookAtCameras) {
    SceneDesc a = rich_scene(), b = rich_scene();
    a.simulation = b.simulation = {.start = 0, .end = 1, .tolerance = 1e-3};
    b.cameras[0].positions[0].z = 3;
    b.render.width = 7;
    b.simulation.tolerance_pixels = 9;
    EXPECT_EQ(text_of(a), text_of(b));
}

double end_of(const SceneDesc& s, double until) { return bake_input(s, until).end; }

TEST(BakeInput, EndsWithTheLatestThatAVideoShows) {
    SceneDesc s = flying_ball();
    s.render.fps = 10;
    EXPECT_NEAR(end_of(s, 0), 2, 1e-15);  // when the exposure of the last frame ends
    s.cameras[0].shutter.duration = 0.25;
    EXPECT_NEAR(end_of(s, 0), 2.15, 1e-15);
    s.cameras[0].shutter.duration = 0;
    EXPECT_NEAR(end_of(s, 0), 1.9, 1e-15);
    s.cameras[0].video_end_inclusive = true;
    EXPECT_EQ(end_of(s, 0), 2);
    EXPECT_EQ(end_of(s, 2), end_of(s, 0));
    s.cameras[0].time_start = 1;
    s.cameras[0].time_end = 1.5;  // slow motion
    EXPECT_EQ(end_of(s, 0), 1.5);
    s.cameras[0].time_end = 0.5;  // backwards
    EXPECT_EQ(end_of(s, 0), 1);
    s.cameras.push_back(s.cameras[0]);
    s.cameras[1].time_end = 7;
    EXPECT_EQ(end_of(s, 0), 7);
    s.simulation.end = 3;
    EXPECT_EQ(end_of(s, 0), 3);
    EXPECT_EQ(end_of(s, 10), 3);
}

TEST(BakeInput, OfAnEndlessVideoIsTheSameForManyFrames) {
    SceneDesc s = flying_ball();
    s.cameras[0].video_end.reset();
    s.simulation.start = 10;
    EXPECT_EQ(end_of(s, 0), 10);  // before the start: nothing to simulate
    EXPECT_EQ(end_of(s, 10), 10);
    EXPECT_EQ(end_of(s, 10.01), 11);
    EXPECT_EQ(end_of(s, 11), 11);
    EXPECT_EQ(end_of(s, 12.5), 14);
    EXPECT_EQ(end_of(s, 14), 14);
    EXPECT_EQ(end_of(s, 14.001), 18);
}

TEST(BakeInput, EndsInTime) {
    SceneDesc s = flying_ball();
    s.cameras[0].video_end.reset();
    EXPECT_EQ(end_of(s, 1e6 - 1), 1e6);
    EXPECT_EQ(end_of(s, 1e308), 1e6);
    s.simulation.start = -1e6;
    EXPECT_EQ(end_of(s, 1e308), 1e6);
    s.cameras[0].video_end = 1e15;
    EXPECT_EQ(end_of(s, 0), 1e6);
}

TEST(BakeInput, FindsTheBodiesAgain) {
    SceneDesc s = rich_scene();
    std::swap(s.bodies[0], s.bodies[3]);
    EXPECT_EQ(bake_input(s, 0).bodies, (std::vector<int>{1, 2, 3}));
    EXPECT_TRUE(has_physics(s));
    for (Body& b : s.bodies) b.physics.reset();
    EXPECT_FALSE(has_physics(s));
}

}  // namespace
}  // namespace drt
