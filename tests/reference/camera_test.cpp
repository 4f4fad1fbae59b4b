// Cameras, shutter and time mapping, against closed forms (numerics.md S1-S3).

#include "reference/camera.h"

#include "drt/base/constants.h"
#include "reference/scene_builder.h"

namespace drt {
namespace {

constexpr int spp = 40000;

TEST(ReferenceCamera, FieldOfViewSpansTheWidthAndPixelZeroIsUpperLeft) {
    // A 4 x 2 picture of the wall z = -1 with a field of view of 90 degrees shows x in [-1, 1], y in [-0.5, 0.5].
    SceneDesc scene = still_scene({0, 0, 0}, {0, 0, -1});
    scene.cameras[0].fov_degrees_start = 90;
    scene.materials = {glow("spot")};
    scene.bodies = {body(Parallelogram{{-1, 0, -1}, {0.5, 0, 0}, {0, 0.5, 0}}, "spot")};
    scene.render.filter.kind = Filter::Kind::box;
    scene.render.filter.radius = 0.5;
    const auto picture = render_reference(scene, 0, 4, 2, 100, 1);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) EXPECT_EQ(value_of(picture, x, y).mean, x == 0 && y == 0);
}

TEST(ReferenceCamera, PositionsAndTargetsAreBezierCurvesAndUpRolls) {
    Camera camera;
    camera.positions = {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}};
    camera.targets = {{0, 0, -4}, {2, 1, -4}};
    camera.up_start = {0, 1, 0};
    camera.up_end = Vec3d{1, 0, 0};
    camera.video_start = 1;
    camera.video_end = 3;
    reference::Random random(1, 0, 0, 0);
    const auto middle = reference::camera_ray(camera, 2, 1, 1, 2, 2, random);  // s = 1/2: eye (1, 1), target (1, 0.5)
    EXPECT_NEAR(middle.origin.x, 1, 1e-12);
    EXPECT_NEAR(middle.origin.y, 1, 1e-12);
    EXPECT_NEAR(middle.direction.y / middle.direction.z, 0.125, 1e-12);
    const auto right = reference::camera_ray(camera, 3, 2, 1, 2, 2, random);  // up = x: right is -y
    EXPECT_LT(right.direction.y, 0.25 / 4);
    const auto past = reference::camera_ray(camera, 4, 1, 1, 2, 2, random);  // stands still after its end
    EXPECT_EQ(past.origin, (Vec3d{2, 0, 0}));
    const auto before = reference::camera_ray(camera, 0.5, 1, 1, 2, 2, random);
    EXPECT_EQ(before.origin, (Vec3d{0, 0, 0}));
}

TEST(ReferenceCamera, WhatGoesLinearlyInAZoom) {
    Camera camera;  // the picture's width at distance 1 goes from 0.7 to 1.6
    camera.fov_degrees_start = degrees(2 * std::atan(0.35));
    camera.fov_degrees_end = degrees(2 * std::atan(0.8));
    camera.video_end = 8;
    const auto angle_at = [&](double time) {
        reference::Random random(1, 0, 0, 0);
        const Vec3d d = reference::camera_ray(camera, time, 2, 1, 2, 2, random).direction;
        return degrees(2 * std::atan(d.x / -d.z));
    };
    EXPECT_NEAR(angle_at(3), camera.fov_degrees_start * 5 / 8 + *camera.fov_degrees_end * 3 / 8, 1e-12);
    camera.zoom = Camera::Zoom::image_width;
    EXPECT_NEAR(angle_at(3), degrees(2 * std::atan(1.0375 / 2)), 1e-12);
    camera.zoom = Camera::Zoom::focal_length;
    EXPECT_NEAR(angle_at(3), degrees(2 * std::atan(0.5 / (5 / 8.0 / 0.7 + 3 / 8.0 / 1.6))), 1e-12);
    for (const double past : {8.0, 9.0}) EXPECT_NEAR(angle_at(past), *camera.fov_degrees_end, 1e-12);
}

TEST(ReferenceCamera, MotionTurnsTheWholeView) {
    Camera camera;
    camera.positions = {{0, 0, 0}};
    camera.targets = {{0, 0, -1}};
    camera.motion.emplace();  // a quarter turn about the view: right becomes up
    camera.motion->keys = {{0, {7, 0, 0}, quat_from_axis_angle({0, 0, 1}, std::numbers::pi / 2), {}}};
    reference::Random random(1, 0, 0, 0);
    const auto ray = reference::camera_ray(camera, 0, 2, 1, 2, 2, random);  // the right edge's middle
    EXPECT_EQ(ray.origin.x, 7);
    EXPECT_NEAR(ray.direction.x, 0, 1e-12);
    EXPECT_NEAR(ray.direction.y / -ray.direction.z, std::tan(std::numbers::pi / 8), 1e-12);
}

TEST(ReferenceCamera, TheIntervalThatHoldsTheFrameChoosesTheCamera) {
    SceneDesc scene = still_scene({0, 0, 0}, {0, 0, -1});
    scene.cameras.push_back(scene.cameras[0]);
    scene.cameras[0].video_end = 2;
    scene.cameras[1].video_start = 2;
    scene.cameras[1].video_end = 4;
    EXPECT_EQ(&reference::camera_at(scene, 1.99), &scene.cameras[0]);
    EXPECT_EQ(&reference::camera_at(scene, 2), &scene.cameras[1]);
    EXPECT_THROW(reference::camera_at(scene, 4), std::invalid_argument);
    scene.cameras[0].video_end_inclusive = scene.cameras[1].video_end_inclusive = true;
    EXPECT_EQ(&reference::camera_at(scene, 2), &scene.cameras[1]);
    EXPECT_EQ(&reference::camera_at(scene, 4), &scene.cameras[1]);
    EXPECT_THROW(reference::camera_at(scene, 4.01), std::invalid_argument);
}

TEST(ReferenceCamera, SceneTime) {
    Camera camera;
    camera.video_start = 2;
    EXPECT_EQ(reference::scene_time(camera, 5), 5);
    camera.time_start = 10;
    EXPECT_EQ(reference::scene_time(camera, 5), 13);
    camera.video_end = 6;
    EXPECT_EQ(reference::scene_time(camera, 5), 13);
    camera.time_end = 8;  // reversed, half speed
    EXPECT_EQ(reference::scene_time(camera, 5), 8.5);
    EXPECT_EQ(reference::scene_time(camera, 6.5), 7.75);  // an exposure past the end keeps its pace
}

/// A bright half-plane whose left edge goes from x = 0 to x = -1 during scene time 0 to 1; one pixel at `x` of it.
SceneDesc moving_edge(double x) {
    SceneDesc scene = still_scene({x, 0, 1}, {x, 0, 0});
    scene.materials = {glow("bright")};
    scene.bodies = {body(Parallelogram{{0, -1, 0}, {4, 0, 0}, {0, 2, 0}}, "bright")};
    Motion motion;
    motion.keys = {{0, {2, 0, 0}, {}, {}}, {1, {1, 0, 0}, {}, {}}};
    scene.bodies[0].motion = motion;
    scene.render.fps = 1;
    scene.cameras[0].shutter.duration.reset();  // one frame: a second
    return scene;
}

TEST(ReferenceShutter, BoxShutterCoversLinearly) {
    for (const double share : {0.25, 0.5, 0.75}) EXPECT_ESTIMATE(render_pixel(moving_edge(-1 + share), spp), share);
}

TEST(ReferenceShutter, OpeningAndClosingMakeATrapezoid) {
    // Share of the exposure after time t, for a trapezoid that opens and closes during k / 2 each.
    const auto after = [](double t, double k) { return 1 - t * t / (k * (1 - k / 2)); };  // t <= k / 2
    for (const double k : {0.5, 1.0}) {
        for (const double t : {0.1, 0.25}) {
            SceneDesc scene = moving_edge(-t);
            scene.cameras[0].shutter.switch_ratio = k;
            EXPECT_ESTIMATE(render_pixel(scene, spp), after(t, k));
            scene.cameras[0].positions[0].x = scene.cameras[0].targets[0].x = -(1 - t);
            EXPECT_ESTIMATE(render_pixel(scene, spp), 1 - after(t, k));
        }
    }
}

TEST(ReferenceShutter, AnInstantIsSharpAndFramesAdvance) {
    SceneDesc scene = moving_edge(-0.5);
    scene.render.fps = 4;
    scene.cameras[0].shutter.duration = 0;
    EXPECT_EQ(render_pixel(scene, 10, 1, 1).mean, 0);
    EXPECT_EQ(render_pixel(scene, 10, 1, 3).mean, 1);
}

TEST(ReferenceShutter, SlowMotionBlursLessAndReversedTimeRunsBackwards) {
    SceneDesc scene = moving_edge(-0.25);
    scene.cameras[0].video_end = 2;  // two seconds of video show one of the scene: the edge passes [0, -0.5]
    scene.cameras[0].time_end = 1;
    EXPECT_ESTIMATE(render_pixel(scene, spp), 0.5);
    scene = moving_edge(-0.7);
    scene.cameras[0].video_end = 2;
    scene.cameras[0].time_start = 1;  // reversed: passes [-1, -0.5]
    scene.cameras[0].time_end = 0;
    EXPECT_ESTIMATE(render_pixel(scene, spp), 0.6);
}

TEST(ReferenceShutter, MovingDotCoversItsChord) {  // S3: chord 2 rho over the way L
    SceneDesc scene = moving_edge(-0.5);
    scene.bodies[0].shape = Disc{{0, 0, 0}, {0, 0, 1}, 0.1};
    scene.bodies[0].motion->keys[0].position.x = 0;
    scene.bodies[0].motion->keys[1].position.x = -1;
    EXPECT_ESTIMATE(render_pixel(scene, spp), 0.2);
}

TEST(ReferenceShutter, AMovingCameraBlursLikeAMovingBody) {
    SceneDesc scene = moving_edge(0);
    scene.bodies[0].motion.reset();  // covers x > 0
    Motion motion;
    motion.keys = {{0, {-0.25, 0, 1}, {}, {}}, {1, {0.75, 0, 1}, {}, {}}};
    scene.cameras[0].motion = motion;
    EXPECT_ESTIMATE(render_pixel(scene, spp), 0.75);
    // Turning about y by -90 degrees (to the right) from 60 degrees left of the edge's direction.
    motion.keys = {{0, {0, 0, 1}, quat_from_axis_angle({0, 1, 0}, std::numbers::pi / 3), {}},
                   {1, {0, 0, 1}, {}, Turn{{0, 1, 0}, -90}}};
    scene.cameras[0].motion = motion;
    EXPECT_ESTIMATE(render_pixel(scene, spp), 1 / 3.0);
}

// A square of half side 1 turns about its centre. Seen at radius 1.2, between its inradius and its corners, a whole
// number of turns covers every direction alike, for the share of directions in which the square reaches that far:
// 1 - 8 acos(1 / 1.2) / (2 pi). Going the short way (no turn at all) would give 0 or 1.
TEST(ReferenceShutter, WholeTurnsCoverTheRingEvenly) {
    for (const double azimuth : {0.0, 0.5, 2.0}) {
        const Vec3d spot{1.2 * std::cos(azimuth), 1.2 * std::sin(azimuth), 0};
        SceneDesc scene = still_scene(spot + Vec3d{0, 0, 1}, spot);
        scene.materials = {glow("bright")};
        scene.bodies = {body(Parallelogram{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, "bright")};
        Motion motion;
        motion.keys = {{0, {0, 0, 0}, {}, {}}, {1, {0, 0, 0}, {}, Turn{{0, 0, 2}, 720}}};
        scene.bodies[0].motion = motion;
        scene.render.fps = 1;
        scene.cameras[0].shutter.duration.reset();
        EXPECT_ESTIMATE(render_pixel(scene, spp), 1 - 4 / std::numbers::pi * std::acos(1 / 1.2));
    }
}

}  // namespace
}  // namespace drt
