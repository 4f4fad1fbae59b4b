#include "drt/scene/camera_time.h"

#include <gtest/gtest.h>

#include <limits>

namespace drt {
namespace {

Camera camera(double start, std::optional<double> end) {
    Camera c;
    c.video_start = start;
    c.video_end = end;
    return c;
}

void expect_frames(const FrameRange& r, double first, double end) {
    EXPECT_EQ(r.first, first);
    EXPECT_EQ(r.end, end);
}

TEST(RecordedFrames, AreHalfOpen) {
    expect_frames(recorded_frames(camera(0, 1), 10), 0, 10);
    expect_frames(recorded_frames(camera(1, 2), 10), 10, 20);
    expect_frames(recorded_frames(camera(0, 0.95), 10), 0, 10);
    expect_frames(recorded_frames(camera(0.05, 0.95), 10), 1, 10);
    expect_frames(recorded_frames(camera(0, 0.3000001), 10), 0, 4);
    expect_frames(recorded_frames(camera(0.5, {}), 10), 5, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(recorded_frames(camera(0.01, 0.09), 10).empty());
    EXPECT_TRUE(recorded_frames(camera(0.01, 0.1), 10).empty());
}

TEST(RecordedFrames, HoldAnInclusiveEnd) {
    Camera c = camera(0, 1);
    c.video_end_inclusive = true;
    expect_frames(recorded_frames(c, 10), 0, 11);
    c.video_end = 0.95;
    expect_frames(recorded_frames(c, 10), 0, 10);
    c = camera(0.01, 0.1);
    c.video_end_inclusive = true;
    expect_frames(recorded_frames(c, 10), 1, 2);
    c = camera(0.5, {});
    c.video_end_inclusive = true;
    expect_frames(recorded_frames(c, 10), 5, std::numeric_limits<double>::infinity());
}

// A time n / fps, however it came about: as a quotient, as a decimal, as a sum, as a difference of large times, and off
// by a few roundings. The frame there begins a video, and does not belong to one that ends there.
TEST(RecordedFrames, DoNotDependOnTheRoundingOfTimes) {
    for (const double fps : {1.0, 10.0, 12.5, 15.0, 23.976, 24.0, 24000 / 1001.0, 25.0, 29.97, 30.0, 48.0, 60.0, 1e4})
        for (const int n : {1, 2, 3, 6, 7, 10, 29, 30, 33, 99, 1000, 86399, 1000000}) {
            const double exact = n / fps;
            double sum = 0;
            if (n <= 1000)
                for (int i = 0; i < n; ++i) sum += 1 / fps;
            const double decimal = std::strtod(std::to_string(n / fps).c_str(), nullptr);
            for (const double t : {exact, std::nextafter(exact, 1e9), std::nextafter(exact, -1e9), exact * (1 + 1e-15),
                                   n <= 1000 ? sum : exact, (1000.1 + exact) - 1000.1,
                                   std::abs(decimal - exact) < 1e-14 ? decimal : exact}) {
                expect_frames(recorded_frames(camera(0, t), fps), 0, n);
                expect_frames(recorded_frames(camera(t, {}), fps), n, std::numeric_limits<double>::infinity());
                Camera c = camera(0, t);
                c.video_end_inclusive = true;
                expect_frames(recorded_frames(c, fps), 0, n + 1);
            }
        }
}

TEST(SceneTime, HasImplicitEnds) {
    Camera c = camera(1, {});
    EXPECT_EQ(scene_time(c, 3), 3);
    c.time_start = 10;
    EXPECT_EQ(scene_time(c, 3), 12);
    c.video_end = 5;
    EXPECT_EQ(scene_time(c, 3), 12);
    c.time_end = 6;
    EXPECT_EQ(scene_time(c, 3), 8);
    EXPECT_EQ(scene_time(c, 7), 4);  // keeps its pace
    c.time_start.reset();
    EXPECT_EQ(scene_time(c, 3), 3.5);
}

TEST(SceneTime, ShareAndExposure) {
    Camera c = camera(1, 5);
    EXPECT_EQ(video_share(c, 2), 0.25);
    EXPECT_EQ(video_share(camera(1, {}), 2), 0);
    EXPECT_EQ(exposure_duration(c, 25), 0.04);
    c.shutter.duration = 0;
    EXPECT_EQ(exposure_duration(c, 25), 0);
}

}  // namespace
}  // namespace drt
