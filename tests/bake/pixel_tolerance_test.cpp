#include "drt/bake/pixel_tolerance.h"

#include <gtest/gtest.h>

#include "bake/bake_scenes.h"

namespace drt {
namespace {

using namespace test;

double smallest(const SceneDesc& s, const Vec3d& center, double radius) {
    return smallest_pixel(
        eye_views(input_over(s, 0, 2)), [&](double) { return center; }, radius);
}

// The view is 2 tan(45 degrees) = 2 wide at distance 1, over 100 pixels.
TEST(PixelTolerance, IsThePixelAtTheBodysDistance) {
    const SceneDesc s = scene_with_camera();
    EXPECT_NEAR(smallest(s, {0, 0, 0}, 1), 0.02 * 19, 1e-12);
    EXPECT_NEAR(smallest(s, {0, 0, 18}, 1), 0.02, 1e-12);
    EXPECT_NEAR(smallest(s, {0, 0, 20}, 3), 0.02 * 3, 1e-12);  // around the eye
}

TEST(PixelTolerance, TakesTheNearestEyeAndTheNarrowestView) {
    SceneDesc s = scene_with_camera();
    s.cameras[0].positions = {{0, 0, 20}, {0, 0, 10}};
    EXPECT_NEAR(smallest(s, {0, 0, 0}, 1), 0.02 * 9, 1e-12);
    s.cameras.push_back(s.cameras[0]);
    s.cameras[1].fov_degrees_end = 10;
    EXPECT_NEAR(smallest(s, {0, 0, 0}, 1), 0.02 * std::tan(radians(5.0)) * 9, 1e-12);
}

TEST(PixelTolerance, GoesWithTheTimeThatTheVideoShows) {
    SceneDesc s = scene_with_camera();
    s.cameras[0].time_start = 2;
    s.cameras[0].time_end = 0;  // backwards: the eye is at z = 20 at the end of the time shown
    s.cameras[0].positions = {{0, 0, 20}, {0, 0, 10}};
    const auto views = eye_views(input_over(s, 0, 2));
    // A body that runs ahead of the eye, always 5 before it.
    const auto center = [](double time) { return Vec3d{0, 0, 10 + 5 * time - 5}; };
    EXPECT_NEAR(smallest_pixel(views, center, 1), 0.02 * 4, 1e-12);
}

TEST(PixelTolerance, OfAnEndlessVideoIsOverTheSimulatedTime) {
    SceneDesc s = scene_with_camera();
    s.cameras[0].video_end.reset();
    s.cameras[0].motion = Motion{{}, {key(0, {0, 0, 30}), key(2, {0, 0, 11})}};
    EXPECT_NEAR(smallest(s, {0, 0, 0}, 1), 0.02 * 10, 1e-12);
}

TEST(PixelTolerance, IsInfiniteWithoutViews) {
    EXPECT_GT(smallest_pixel(
                  {}, [](double) { return Vec3d{}; }, 1),
              1e300);
}

}  // namespace
}  // namespace drt
