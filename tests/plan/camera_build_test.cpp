// The camera of an exposure: what goes from start to end, how it goes there and that it stays there.

#include <gtest/gtest.h>

#include <cmath>

#include "drt/base/simd.h"
#include "drt/plan/prepare.h"
#include "plan_parts.h"

namespace drt {
namespace {

/// 10 fps; frame k is at k / 10 of the camera's video.
Camera camera() {
    Camera c;
    c.positions = {{0, 0, 0}};
    c.targets = {{0, 0, -4}};
    c.video_end = 1;
    return c;
}

CameraModel<double> at_frame(const Camera& c, int frame) {
    SceneDesc scene;
    scene.render.fps = 10;
    scene.render.width = 2;  // pixel_size is half of what the picture's width spans at distance 1
    scene.cameras = {c};
    scene.cameras[0].name = "it";
    return build_camera(scene.render, c, exposure_of_frame(scene, frame, "it"));  // named: any frame at all
}

double angle(const View<double>& v) { return degrees(2 * std::atan(v.pixel_size)); }

// ---- zooms ---------------------------------------------------------------------------------------------------------

Camera zooming(Camera::Zoom zoom, double start, double end) {
    Camera c = camera();
    c.zoom = zoom;
    c.fov_degrees_start = start;
    c.fov_degrees_end = end;
    return c;
}

double angle_between(Camera::Zoom zoom, double start, double end, double s) {
    const double a = std::tan(radians(start) / 2), b = std::tan(radians(end) / 2);
    if (zoom == Camera::Zoom::image_width) return degrees(2 * std::atan(a + (b - a) * s));
    if (zoom == Camera::Zoom::focal_length) return degrees(2 * std::atan(1 / (1 / a + (1 / b - 1 / a) * s)));
    return start + (end - start) * s;
}

constexpr Camera::Zoom all_zooms[] = {Camera::Zoom::angle, Camera::Zoom::image_width, Camera::Zoom::focal_length};

TEST(BuildCamera, ZoomsGoLinearlyInWhatTheySay) {
    for (const Camera::Zoom zoom : all_zooms)
        for (const auto& [start, end] : {std::pair{50.0, 30.0}, {1.0, 120.0}, {170.0, 20.0}, {1e-3, 2e-3}})
            for (const double duration : {0.0, 0.02, 0.1, 0.7}) {
                Camera c = zooming(zoom, start, end);
                c.shutter.duration = duration;
                const CameraModel<double> m = at_frame(c, 3);
                const CameraModel<float> f = cast<float>(m);
                for (const double u : {0.0, 0.3, 0.5, 1.0}) {
                    const double right = angle_between(zoom, start, end, 0.3 + u * duration);
                    EXPECT_NEAR(angle(view_at(m, u)), right, 1e-12 * right) << start << " to " << end;
                    const double single = degrees(2 * std::atan(double(view_at(f, float(u)).pixel_size)));
                    EXPECT_NEAR(single, right, 2e-6 * right) << start << " to " << end;
                }
            }
}

// The legacy zoom of 0.7 to 1.6, at 3/8 of the way.
TEST(BuildCamera, AnImageWidthOfALegacyZoom) {
    Camera c = zooming(Camera::Zoom::image_width, degrees(2 * std::atan(0.35)), degrees(2 * std::atan(0.8)));
    c.video_end = 0.8;
    EXPECT_NEAR(angle(view_at(at_frame(c, 3), 0.0)), degrees(2 * std::atan(1.0375 / 2)), 1e-12);
}

TEST(BuildCamera, ConstantAnglesAreTheSameInEveryZoom) {
    for (const double fov : {1e-300, 1e-3, 45.0, 179.9, std::nextafter(180.0, 0.0)})
        for (const Camera::Zoom zoom : all_zooms) {
            Camera c = zooming(zoom, fov, fov);
            const CameraModel<double> m = at_frame(c, 3);
            EXPECT_FALSE(m.moving);
            EXPECT_EQ(view_at(m, 0.4).pixel_size, std::max(std::tan(radians(fov) / 2), 1e-150));
            c.fov_degrees_end.reset();
            EXPECT_EQ(view_at(at_frame(c, 3), 0.4).pixel_size, view_at(m, 0.4).pixel_size);
        }
}

TEST(BuildCamera, TheLimitsOfTheAngleGiveFinitePictures) {
    const double widest = std::nextafter(180.0, 0.0), least = 5e-324;
    for (const Camera::Zoom zoom : all_zooms)
        for (const auto& [start, end] : {std::pair{least, widest}, {widest, least}, {90.0, widest}}) {
            Camera c = zooming(zoom, start, end);
            for (const double duration : {0.1, 1.0, 5.0}) {
                c.shutter.duration = duration;
                const CameraModel<double> m = at_frame(c, 0);
                const CameraModel<float> f = cast<float>(m);
                for (double u = 0; u <= 1; u += 1.0 / 64) {
                    const double size = view_at(m, u).pixel_size;
                    const float single = view_at(f, float(u)).pixel_size;
                    EXPECT_TRUE(size >= 0 && std::isfinite(size)) << start << " to " << end << " at " << u;
                    EXPECT_TRUE(single >= 0 && std::isfinite(single)) << start << " to " << end << " at " << u;
                }
            }
        }
}

// ---- past the ends -------------------------------------------------------------------------------------------------

Camera everything_moves() {
    Camera c = zooming(Camera::Zoom::angle, 50, 170);
    c.positions = {{0, 0, 0}, {1, 2, 0}, {2, 0, 1}};
    c.targets = {{0, 0, -4}, {2, 1, -4}};
    c.up_start = {0, 1, 0};
    c.up_end = Vec3d{1, 1, 0};
    c.lens.focus_start = 10;
    c.lens.focus_end = 1;
    return c;
}

void expect_same(const View<double>& a, const View<double>& b) {
    EXPECT_LE(length(a.eye - b.eye), 1e-14);
    EXPECT_LE(length(a.forward - b.forward), 1e-14);
    EXPECT_LE(length(a.up - b.up), 1e-14);
    EXPECT_NEAR(a.pixel_size, b.pixel_size, 1e-12 * b.pixel_size);
    EXPECT_NEAR(a.focus, b.focus, 1e-14);
}

// Frame 9 of an exposure of 0.4 s: at a quarter of it the video ends.
TEST(BuildCamera, StandsStillAfterTheEnd) {
    for (const Camera::Zoom zoom : all_zooms) {
        Camera c = everything_moves();
        c.zoom = zoom;
        c.shutter.duration = 0;
        c.video_end_inclusive = true;
        const View<double> end = view_at(at_frame(c, 10), 0.0);
        EXPECT_NEAR(angle(end), 170, 1e-10);
        EXPECT_EQ(end.focus, 1);
        EXPECT_EQ(end.eye, (Vec3d{2, 0, 1}));
        c.shutter.duration = 0.4;
        const CameraModel<double> m = at_frame(c, 9);
        EXPECT_TRUE(m.moving);
        for (const double u : {0.25, 0.5, 1.0}) expect_same(view_at(m, u), end);
        EXPECT_NEAR(view_at(m, 0.125).focus, 10 - 9 * 0.95, 1e-14);  // and keeps its pace until then
        EXPECT_FALSE(at_frame(c, 10).moving);
        expect_same(view_at(at_frame(c, 12), 0.5), end);
    }
}

TEST(BuildCamera, StandsStillBeforeTheStart) {
    Camera c = everything_moves();
    c.video_start = 0.5;
    c.video_end = 1.5;
    c.shutter.duration = 0;
    const View<double> start = view_at(at_frame(c, 5), 0.0);
    expect_same(view_at(at_frame(c, 2), 0.0), start);
    c.shutter.duration = 0.4;
    const CameraModel<double> m = at_frame(c, 4);
    for (const double u : {0.0, 0.1, 0.25}) expect_same(view_at(m, u), start);
    EXPECT_NEAR(view_at(m, 0.75).focus, 10 - 9 * 0.2, 1e-14);
    c.shutter.duration = 2;
    const CameraModel<double> whole = at_frame(c, 4);  // from before the start until after the end
    expect_same(view_at(whole, 0.05), start);
    EXPECT_NEAR(view_at(whole, 0.55).focus, 1, 1e-14);
    EXPECT_NEAR(view_at(whole, 0.3).focus, 5.5, 1e-14);
    EXPECT_EQ(view_at(whole, 1.0).focus, 1);
}

TEST(BuildCamera, AKeyframedPathRunsOnInSceneTime) {
    Camera c = camera();
    c.motion = Motion{{}, {key(0, {0, 0, 0}), key(2, {2, 0, 0})}};
    c.shutter.duration = 0.4;
    EXPECT_NEAR(view_at(at_frame(c, 9), 1.0).eye.x, 1.3, 1e-14);
}

TEST(BuildCamera, AnEndlessVideoStaysAtItsStart) {
    Camera c = everything_moves();
    c.positions.resize(1);
    c.targets.resize(1);
    c.video_end.reset();
    const CameraModel<double> m = at_frame(c, 70);
    EXPECT_FALSE(m.moving);
    EXPECT_NEAR(angle(view_at(m, 0.5)), 50, 1e-12);
    EXPECT_EQ(view_at(m, 0.5).focus, 10);
}

// ---- many control points -------------------------------------------------------------------------------------------

TEST(BuildCamera, ManyControlPointsAreExactInBothPrecisions) {
    for (const size_t n : {3, 20, 130, 300, 1500}) {
        Camera c = camera();
        c.positions.clear();
        for (size_t i = 0; i < n; ++i) c.positions.push_back({double(i % 3), 0, 5});
        for (const int frame : {0, 4, 9}) {
            c.shutter.duration = 0.1;
            const CameraModel<double> m = at_frame(c, frame);
            for (const double u : {0.0, 0.4, 1.0}) {
                std::vector<Vec3<long double>> points(c.positions.begin(), c.positions.end());
                const long double s = frame / 10.0L + u * 0.1L;
                for (; points.size() > 1; points.pop_back())
                    for (size_t i = 0; i + 1 < points.size(); ++i) points[i] = points[i] * (1 - s) + points[i + 1] * s;
                const double x = double(points[0].x);
                EXPECT_NEAR(view_at(m, u).eye.x, x, 1e-14 + 1e-15 * double(n)) << n << " points, frame " << frame;
                EXPECT_NEAR(view_at(cast<float>(m), float(u)).eye.x, x, 2e-6) << n << " points, frame " << frame;
            }
        }
    }
}

// ---- instants without a view ---------------------------------------------------------------------------------------

void expect_view(const View<double>& v) {
    EXPECT_TRUE(is_finite(v.forward) && is_finite(v.right) && is_finite(v.up));
    EXPECT_NEAR(length(v.forward), 1, 1e-6);
    EXPECT_NEAR(length(v.right), 1, 1e-6);
    EXPECT_NEAR(length(v.up), 1, 1e-6);
    EXPECT_NEAR(dot(v.forward, v.right), 0, 1e-6);
}

void expect_views(const Camera& c, int frame) {
    const CameraModel<double> m = at_frame(c, frame);
    const CameraModel<float> f = cast<float>(m);
    for (int i = 0; i <= 64; ++i) {
        expect_view(view_at(m, i / 64.0));
        expect_view(cast<double>(view_at(f, float(i) / 64)));
    }
}

TEST(BuildCamera, AnInstantWithoutUpIsAsJustAfter) {
    Camera c = camera();  // flies over its target
    c.positions = {{-1, 3, -4}, {1, 3, -4}};
    c.shutter.duration = 0;
    const View<double> over = view_at(at_frame(c, 5), 0.0);
    EXPECT_LE(length(over.forward - Vec3d{0, -1, 0}), 1e-6);
    EXPECT_LE(length(over.up - Vec3d{-1, 0, 0}), 1e-6);  // looks back
    c.shutter.duration = 0.2;
    expect_views(c, 4);
    expect_views(c, 5);
}

TEST(BuildCamera, OppositeUpsTurnThePictureOver) {
    Camera c = camera();
    c.up_start = {0.1, 0.7, 0.2};
    c.up_end = Vec3d{-0.1, -0.7, -0.2};
    c.shutter.duration = 0;
    EXPECT_GT(view_at(at_frame(c, 4), 0.0).up.y, 0.9);
    EXPECT_LT(view_at(at_frame(c, 5), 0.0).up.y, -0.9);
    c.shutter.duration = 0.2;
    expect_views(c, 4);
}

TEST(BuildCamera, AnEyeMayPassThroughItsTarget) {
    Camera c = camera();
    c.positions = {{0, 0, 0}, {0, 0, -8}};
    c.shutter.duration = 0;
    EXPECT_EQ(view_at(at_frame(c, 4), 0.0).forward, (Vec3d{0, 0, -1}));
    EXPECT_LE(length(view_at(at_frame(c, 5), 0.0).forward - Vec3d{0, 0, 1}), 1e-12);
    c.shutter.duration = 0.2;
    expect_views(c, 4);
}

TEST(BuildCamera, UpMayHaveAnyLength) {
    for (const double size : {1e-25, 1e15}) {
        Camera c = camera();
        c.up_start = {0, size, 0};
        c.up_end = Vec3d{size, size, 0};
        expect_views(c, 3);
        EXPECT_NEAR(view_at(cast<float>(at_frame(c, 3)), 0.0f).up.x, 0.3 / std::hypot(1, 0.3), 1e-6);
    }
}

}  // namespace
}  // namespace drt
