#include "drt/plan/exposure.h"

#include <gtest/gtest.h>

#include "plan_parts.h"

namespace drt {
namespace {

Camera camera(const std::string& name, double start, std::optional<double> end) {
    Camera c;
    c.name = name;
    c.video_start = start;
    c.video_end = end;
    return c;
}

SceneDesc scene(std::vector<Camera> cameras) {
    SceneDesc s;
    s.render.fps = 25;
    s.cameras = std::move(cameras);
    return s;
}

void expect_exposure(const Exposure& e, double s0, double s1, double time0, double time1) {
    EXPECT_NEAR(e.s0, s0, 1e-14);
    EXPECT_NEAR(e.s1, s1, 1e-14);
    EXPECT_NEAR(e.time0, time0, 1e-14);
    EXPECT_NEAR(e.time1, time1, 1e-14);
}

TEST(Exposure, WithoutAnyValuesTimeIsVideoTimeAndTheShutterAFrame) {
    const SceneDesc s = scene({camera("a", 0, {})});
    const Exposure e = exposure_of_frame(s, 50);
    EXPECT_EQ(e.camera, 0);
    EXPECT_EQ(e.video_time, 2);
    expect_exposure(e, 0, 0, 2, 2.04);
}

TEST(Exposure, AnEndlessCameraStaysAtItsStart) {
    Camera c = camera("a", 1, {});
    c.time_start = 100;
    c.shutter.duration = 0.5;
    expect_exposure(exposure_of_frame(scene({c}), 50), 0, 0, 101, 101.5);
}

TEST(Exposure, TheParameterGoesOverTheVideo) {
    SceneDesc s = scene({camera("a", 1, 5)});
    expect_exposure(exposure_of_frame(s, 25), 0, 0.01, 1, 1.04);
    expect_exposure(exposure_of_frame(s, 75), 0.5, 0.51, 3, 3.04);
    s.cameras[0].shutter.duration = 0.0;
    expect_exposure(exposure_of_frame(s, 75), 0.5, 0.5, 3, 3);
    s.cameras[0].shutter.duration = 0.12;  // the exposure of the last frame runs on at the same pace
    expect_exposure(exposure_of_frame(s, 124), 0.99, 1.02, 4.96, 5.08);
    s.cameras[0].video_end_inclusive = true;
    expect_exposure(exposure_of_frame(s, 125), 1, 1.03, 5, 5.12);
}

TEST(Exposure, SceneTimeMayBeSlowFastFrozenOrReversed) {
    const auto frame = [](std::optional<double> start, std::optional<double> end) {
        Camera c = camera("a", 1, 5);
        c.time_start = start;
        c.time_end = end;
        return exposure_of_frame(scene({c}), 75);  // at half the video
    };
    expect_exposure(frame(10, 10.4), 0.5, 0.51, 10.2, 10.204);  // ten times slower
    expect_exposure(frame(10, 50), 0.5, 0.51, 30, 30.4);        // ten times faster
    expect_exposure(frame(7, 7), 0.5, 0.51, 7, 7);
    expect_exposure(frame(4, 0), 0.5, 0.51, 2, 1.96);
    expect_exposure(frame(10, {}), 0.5, 0.51, 12, 12.04);  // implicit end: the natural pace
    expect_exposure(frame({}, 9), 0.5, 0.51, 5, 5.08);     // implicit start: video time
}

TEST(Exposure, ACutBelongsToTheCameraThatBegins) {
    const SceneDesc s = scene({camera("a", 0, 1), camera("b", 1, 2), camera("c", 3, {})});
    const auto who = [&](int frame) { return exposure_of_frame(s, frame).camera; };
    EXPECT_EQ(who(0), 0);
    EXPECT_EQ(who(24), 0);
    EXPECT_EQ(who(25), 1);
    EXPECT_EQ(who(49), 1);
    EXPECT_THROW(who(50), Error);
    EXPECT_EQ(who(75), 2);
    EXPECT_EQ(who(100000), 2);
}

TEST(Exposure, AnInclusiveEndIsRecordedUnlessAnotherCameraRecordsIt) {
    SceneDesc s = scene({camera("a", 0, 1), camera("b", 1, 2), camera("c", 2, 3)});
    s.cameras[0].video_end_inclusive = s.cameras[1].video_end_inclusive = true;
    const auto who = [&](int frame) { return exposure_of_frame(s, frame).camera; };
    EXPECT_EQ(who(25), 1);
    EXPECT_EQ(who(50), 2);
    EXPECT_THROW(who(75), Error);
    s.cameras[2].video_end_inclusive = true;
    EXPECT_EQ(who(75), 2);
    EXPECT_THROW(who(76), Error);
    std::swap(s.cameras[0], s.cameras[2]);  // whatever the order in the file
    EXPECT_EQ(s.cameras[size_t(who(25))].name, "b");
    EXPECT_EQ(s.cameras[size_t(who(50))].name, "c");
    EXPECT_EQ(s.cameras[size_t(who(75))].name, "c");
}

TEST(Exposure, OfOverlappingCamerasTheFirstOrTheNamedOneRecords) {
    const SceneDesc s = scene({camera("a", 0, 2), camera("b", 1, 3)});
    EXPECT_EQ(exposure_of_frame(s, 30).camera, 0);
    EXPECT_EQ(exposure_of_frame(s, 30, "b").camera, 1);
    EXPECT_NEAR(exposure_of_frame(s, 30, "b").s0, 0.1, 1e-15);
}

TEST(Exposure, FramesThatNobodyRecordsAreUsageErrorsThatNameTheRecordedOnes) {
    const SceneDesc s = scene({camera("a", 0, 1), camera("b", 2, {})});
    try {
        exposure_of_frame(s, 30);
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(e.what()).find("no camera records frame 30"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("camera \"a\" records frames 0..24"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("camera \"b\" records frames 50.."), std::string::npos) << e.what();
    }
    try {
        exposure_of_frame(s, 0, "c");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::usage);
        EXPECT_NE(std::string(e.what()).find("no such camera"), std::string::npos) << e.what();
    }
}

}  // namespace
}  // namespace drt
