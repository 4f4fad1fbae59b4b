// Which frames a video has, and what its camera does at its end.

#include <cmath>

#include "drt/base/constants.h"
#include "render_programs.h"

namespace drt {
namespace {

std::string number(double v) {
    std::string text(40, ' ');
    text.resize(size_t(std::snprintf(text.data(), text.size(), "%.17g", v)));
    return text;
}

/// A picture of 10 fps and its camera.
std::string scene_with(const std::string& camera) {
    return replaced(small_scene, "position: [0, 2, 6], target: [0, 1, 0], fov_degrees: 40", camera);
}

double largest_difference(const Image& a, const Image& b) {
    double largest = a.data.size() == b.data.size() ? 0 : 1e30;
    for (size_t i = 0; i < std::min(a.data.size(), b.data.size()); ++i)
        largest = std::max(largest, double(std::abs(a.data[i] - b.data[i])));
    return largest;
}

TEST(RenderTime, AVideoHasTheFramesBeforeItsEnd) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", small_scene);
    EXPECT_EQ(render({scene, "--check", "--frames", "0-9"}).exit_code, 0);
    EXPECT_EQ(render({scene, "--check", "--frames", "0-10"}).exit_code, 2);
    const std::string inclusive = folder.write(
        "inclusive.yaml", replaced(small_scene, "video_end: 1", "video_end: 1, video_end_inclusive: true"));
    EXPECT_EQ(render({inclusive, "--check", "--frames", "0-10"}).exit_code, 0);
    EXPECT_TRUE(contains(render({inclusive, "--check", "-f", "11"}).err, "records frames 0..10"));
}

TEST(RenderTime, AZoomEndsWhereItSays) {
    const TempFolder folder;
    const std::string moving =
        "position: [0, 2, 6], target: [0, 1, 0], fov_degrees: {start: 50, end: 170}, "
        "lens: {aperture_radius: 0.1, focus_distance: {start: 10, end: 1}}, "
        "up: {start: [0, 1, 0], end: [0.2, 0.4, 0]}, video_end_inclusive: true";
    const std::string standing =
        "position: [0, 2, 6], target: [0, 1, 0], fov_degrees: 170, "
        "lens: {aperture_radius: 0.1, focus_distance: 1}, up: [0.2, 0.4, 0]";
    const Image end = render_exr(folder, "a", {folder.write("a.yaml", scene_with(moving)), "-f", "10"});
    const Image right = render_exr(folder, "b", {folder.write("b.yaml", scene_with(standing)), "-f", "9"});
    double mean = 0;
    for (size_t i = 0; i < end.data.size(); ++i) mean += double(end.data[i] - right.data[i]) / double(end.data.size());
    EXPECT_NEAR(mean, 0, 0.02);                  // frames have their own noise
    EXPECT_FLOAT_EQ(end.pixel(12, 0)[2], 0.3f);  // no floor above the horizon, but the background
    EXPECT_LT(end.pixel(12, 15)[2], 0.29f);
}

TEST(RenderTime, ACurveMayHaveAnyNumberOfPoints) {
    const TempFolder folder;
    const auto picture = [&](int points) {
        std::string positions = "positions: [";
        for (int i = 0; i < points; ++i) positions += std::string(i == 0 ? "[0, 2, " : ", [0, 2, ") + "6]";
        const std::string text = scene_with(positions + "], target: [0, 1, 0], fov_degrees: 40");
        const ProcessResult r =
            render({folder.write("a.yaml", text), "-f", "9", "-o", folder.file("many.exr"), "--progress", "none"});
        EXPECT_EQ(r.exit_code, 0);
        EXPECT_FALSE(contains(r.err, "warning")) << r.err;
        return read_image_raw(folder.file("many.exr"));
    };
    const Image one = picture(1);
    for (const int points : {2, 130, 1500}) EXPECT_EQ(picture(points).data, one.data) << points;
}

// ---- legacy scenes -------------------------------------------------------------------------------------------------

const std::string legacy_scene =
    "settings S { width 24 height 16 fps 10 blur_samples 4 dof_samples 2 dof_c 0.1 interpolate_samples 1 }\n"
    "camera A { video_start 0 video_end 0.8 time_start 1 time_end 0.2 FOV_start 0.7 FOV_end 1.6 DOF_start 4 DOF_end 8\n"
    "  add_position { 0 2 6 } add_position { 2 2 6 } add_target { 0 1 0 } sky_end { 0.2 1 0 } }\n"
    "camera B { video_start 0.8 video_end 1.6 FOV_start 1.6 FOV_end 0.7 add_position { 0 2 6 } }\n"
    "sphere ball { position { 0 1 0 } } plane floor { } light_bulb lamp { position { 2 5 3 } }\n";

TEST(RenderTime, ALegacyVideoIsTheSameConverted) {
    const TempFolder folder;
    const std::string legacy = folder.write("scene.txt", legacy_scene), yaml = folder.file("scene.yaml");
    for (const std::string fov : {"half-width", "distance"}) {
        ASSERT_EQ(test::run_process(DRT_CONVERT, {legacy, "-o", yaml, "--fov", fov}).exit_code, 0);
        for (const std::string frame : {"0", "3", "7", "8", "15", "16"}) {
            const Image direct = render_exr(folder, "direct", {legacy, "--fov", fov, "-f", frame});
            EXPECT_EQ(render_exr(folder, "converted", {yaml, "-f", frame}).data, direct.data) << fov << ' ' << frame;
        }
        EXPECT_EQ(render({yaml, "--check", "-f", "17"}).exit_code, 2);
        EXPECT_EQ(render({legacy, "--check", "-f", "17"}).exit_code, 2);
    }
}

// FOV itself goes linearly: at 3/8 of the way from 0.7 to 1.6 it is 1.0375.
TEST(RenderTime, ALegacyZoomGoesLinearlyInItsNumber) {
    const TempFolder folder;
    const std::string zoom =
        folder.write("zoom.txt",
                     "settings S { width 96 height 64 fps 10 }\n"
                     "camera A { video_start 0 video_end 0.8 FOV_start 0.7 FOV_end 1.6 }\n"
                     "sphere ball { } plane floor { position { 0 -1 0 } } light_point lamp { position { 2 5 3 } }\n");
    for (const auto& [option, half_tangent] : {std::pair{"half-width", 1.0375 / 2}, {"distance", 1 / 1.0375}}) {
        const Image picture = render_exr(folder, "zoom", {zoom, "-f", "3", "--fov", option});
        const std::string still = replaced(
            replaced(read_bytes(zoom), "FOV_start 0.7", "FOV_start " + number(2 * half_tangent)), "FOV_end 1.6", "");
        const Image right = render_exr(folder, "still", {folder.write("still.txt", still), "-f", "3"});
        EXPECT_LE(largest_difference(picture, right), 1e-4) << option;
    }
}

}  // namespace
}  // namespace drt
