// The manual's example, value by value.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "drt/base/constants.h"
#include "drt/formats/formats.h"
#include "drt/scene/mass.h"

namespace drt {
namespace {

const std::string example = DRT_TEST_DATA "/manual_example.txt";

Material ball_material() {
    Material m;
    m.name = "BallRed";
    m.ambient = {0.6f, 0, 0};
    m.diffuse = {0.5f, 0, 0};
    m.specular = Color(0.7f);
    m.shininess = 20;
    m.reflectance = 0.2;
    m.reflection_spread_degrees = degrees(0.15);
    m.refraction_index = 1.3;
    m.texture = "BallRed";
    m.scale_u = 0.5;
    return m;
}

Material table_material() {
    Material m;
    m.name = "BilliardTable";
    m.ambient = {0.2f, 0.4f, 0.25f};
    m.diffuse = {0.1f, 0.4f, 0.15f};
    m.specular = Color(0.05f);
    m.shininess = 20;
    m.refraction_index = 1.3;
    return m;
}

Camera example_camera() {
    Camera c;
    c.name = "Camera1";
    c.positions = {{135, 20, 70}, {50, 20, 70}};
    c.targets = {{120, 4, 55}, {0, 0, 30}};
    c.up_end = Vec3d{0, 1, 0};
    c.fov_degrees_start = degrees(2 * std::atan(2.5 / 2));
    c.fov_degrees_end = degrees(2 * std::atan(6.0 / 2));
    c.lens = {0.2, 20, 60, Lens::Distribution::radial, Lens::FocusSurface::sphere};
    c.shutter = {std::nullopt, 0.2};
    c.zoom = Camera::Zoom::image_width;
    c.video_end = 8;
    c.video_end_inclusive = true;
    c.time_start = 0;
    c.time_end = 8;
    return c;
}

SceneDesc expected_example() {
    SceneDesc s;
    s.render.fps = 2;
    s.render.spp = 32 * 18;
    s.render.max_depth = 1;
    s.render.filter.kind = Filter::Kind::point;
    s.ambient_light = Color(0.12f);
    s.textures = {{"BallRed", DRT_TEST_DATA "/textures/ball_red.tga", Texture::ColorSpace::automatic}};
    s.materials = {ball_material(), table_material()};
    Body ball{"BallRed", Sphere{{60, 3.8, 54.5}, 4, {0, 1, 0}, {1, 0, 1}}, "BallRed", {}, PhysicsDesc{}};
    s.gravity = {0, -9.81, 0};
    ball.physics->density = 1;
    ball.physics->impulses = {{0.1, {5000, 0, 0}, {}}};
    Body table{"ground", Box{{100, -2.5, 50}, {200, 5, 100}, {}}, "BilliardTable", {}, PhysicsDesc{}};
    table.physics->kind = PhysicsDesc::Kind::fixed;
    s.bodies = {ball, table};
    s.cameras = {example_camera()};
    return s;
}

TEST(LegacyExample, IsExactlyTheDocumentedScene) {
    const SceneDesc got = read_legacy_scene(example).scene;
    const SceneDesc want = expected_example();
    EXPECT_EQ(got.render, want.render);
    EXPECT_EQ(got.textures, want.textures);
    EXPECT_EQ(got.materials, want.materials);
    EXPECT_EQ(got.bodies, want.bodies);
    EXPECT_EQ(got.cameras, want.cameras);
    EXPECT_TRUE(got == want);
}

// model.md section 6: the ball of radius 4 leaves the blow with 18.7 units / s.
TEST(LegacyExample, BlowIsAsStrongAsDocumented) {
    const Body ball = read_legacy_scene(example).scene.bodies[0];
    const double speed = length(ball.physics->impulses[0].impulse) / mass_properties(ball.shape, *ball.physics)->mass;
    EXPECT_NEAR(speed, 18.65, 0.005);
}

TEST(LegacyExample, KnowsWhereThingsWereWritten) {
    const SceneDesc s = read_legacy_scene(example).scene;
    EXPECT_EQ(to_string(s.sources.find("textures[0].file")), example + ":29:14");
    EXPECT_EQ(to_string(s.sources.find("bodies[0].radius")), example + ":41:37");
    EXPECT_EQ(to_string(s.sources.find("bodies[0].physics.impulses[0].time")), example + ":43:5");
    EXPECT_EQ(to_string(s.sources.find("bodies[1].physics")), example + ":48:49");
    EXPECT_EQ(to_string(s.sources.find("cameras[0].fov_degrees.end")), example + ":12:51");
}

TEST(LegacyExample, TellsEveryDefaultAndAssumption) {
    const SceneRead read = read_legacy_scene(example);
    EXPECT_EQ(read.files, std::vector<std::string>{example});
    std::string text;
    for (const Diagnostic& d : read.notes) {
        EXPECT_NE(d.severity, Severity::error);
        text += to_string(d) + '\n';
    }
    for (const char* words :
         {":16:1: note: default used: phong_info diffuse_refraction = 0 (BallRed, BilliardTable)",
          "warning: the scene has no lights", "assumed: angle of view = 2 atan(FOV / 2)", "assumed: gravity 0 -9.81 0",
          "assumed: density 1", "assumed: restitution 0, friction 0.5, of every body",
          "assumed: impulse = force * 0.05 s", "assumed: ambient light 0.12", "spp = 576",
          "dropped: soft_shadow_samples", "dropped: diffuse_reflection_samples",
          "diffuse_refraction_samples is 0: refractions are sharp", "boxes with use_physics stay"})
        EXPECT_NE(text.find(words), std::string::npos) << words << "\nnot in\n" << text;
}

TEST(LegacyExample, OptionsReplaceTheAssumptions) {
    LegacyOptions o;
    o.fov = LegacyOptions::Fov::distance;
    o.gravity = {0, 0, -1.62};
    o.density = 3;
    o.legacy_step = 0.01;
    o.ambient_light = 0.5f;
    o.add_lights = true;
    const SceneDesc s = read_legacy_scene(example, o).scene;
    EXPECT_EQ(s.cameras[0].fov_degrees_start, degrees(2 * std::atan(1 / 2.5)));
    EXPECT_EQ(s.cameras[0].zoom, Camera::Zoom::focal_length);
    EXPECT_EQ(s.gravity, (Vec3d{0, 0, -1.62}));
    EXPECT_EQ(s.bodies[0].physics->density, 3);
    EXPECT_EQ(s.bodies[0].physics->impulses[0].impulse, (Vec3d{1000, 0, 0}));
    EXPECT_EQ(s.ambient_light, Color(0.5f));
    ASSERT_EQ(s.lights.size(), 1u);
    const auto& bulb = std::get<SphereLight>(s.lights[0].shape);
    EXPECT_GT(bulb.center.y, 20);  // above the camera
    EXPECT_EQ(s.lights[0].falloff, Light::Falloff::none);
}

TEST(LegacyExample, ShippedCopyIsTheManualsText) {
    const auto text = [](const std::string& path) {
        std::ostringstream out;
        out << std::ifstream(path, std::ios::binary).rdbuf();
        return out.str();
    };
    EXPECT_FALSE(text(example).empty());
    EXPECT_EQ(text(example), text(DRT_SOURCE_DIR "/scenes/legacy/manual-example.txt"));
}

}  // namespace
}  // namespace drt
