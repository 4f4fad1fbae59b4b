// The command line, taken apart.
#include <gtest/gtest.h>

#include "apps/drt_render/options.h"

namespace drt {
namespace {

RenderArguments parse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "drt-render");
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    return parse_arguments(int(arguments.size()), argv.data()).value();
}

TEST(ParseArguments, TakesOutputsAndTheSceneInAnyOrder) {
    const RenderArguments a = parse({"-o", "a.exr", "scene.yaml", "--output=b.png"});
    EXPECT_EQ(a.scene, "scene.yaml");
    EXPECT_EQ(a.outputs, (std::vector<std::string>{"a.exr", "b.png"}));
    EXPECT_EQ(parse({"-s", "scene.txt", "-o", "a.exr"}).scene, "scene.txt");
    EXPECT_EQ(a.frames, std::vector<int>{0});
    EXPECT_FALSE(a.overrides.spp || a.overrides.seed || a.overrides.max_depth || a.overrides.width);
    EXPECT_EQ(a.time_limit, 0);
}

TEST(ParseArguments, ReadsNumbers) {
    const RenderArguments a = parse({"s.yaml", "-o", "a.exr", "--spp", "016", "--seed=4294967295", "--max-depth", "0",
                                     "-r", "65536x1", "--exposure", "-1.5", "-t", "7", "-f", "45"});
    EXPECT_EQ(a.overrides.spp, 16);  // decimal
    EXPECT_EQ(a.overrides.seed, 4294967295u);
    EXPECT_EQ(a.overrides.max_depth, 0);
    EXPECT_EQ(a.overrides.width, 65536);
    EXPECT_EQ(a.overrides.height, 1);
    EXPECT_EQ(a.display.exposure, -1.5f);
    EXPECT_EQ(a.threads, 7);
    EXPECT_EQ(a.frames, std::vector<int>{45});
}

TEST(ParseArguments, ReadsDurations) {
    const auto limit = [](const std::string& text) {
        return parse({"s.yaml", "-o", "a.exr", "--time-limit", text}).time_limit;
    };
    EXPECT_EQ(limit("90"), 90);
    EXPECT_EQ(limit("90s"), 90);
    EXPECT_EQ(limit("1.5m"), 90);
    EXPECT_EQ(limit("2h"), 7200);
    EXPECT_EQ(limit("0.25"), 0.25);
}

TEST(ParseArguments, ReadsSnapshots) {
    const auto snapshot = [](const std::string& text) {
        return parse({"s.yaml", "-o", "a.exr", "--snapshot", text}).snapshot.value();
    };
    EXPECT_EQ(snapshot("a.png").path, "a.png");
    EXPECT_EQ(snapshot("a.png").interval, 0);
    EXPECT_EQ(snapshot("a.png:2m").path, "a.png");
    EXPECT_EQ(snapshot("a.png:2m").interval, 120);
    EXPECT_EQ(snapshot("C:a.png").path, "C:a.png");
    EXPECT_EQ(snapshot("C:a.png:5").path, "C:a.png");
}

TEST(ParseArguments, TheLastOfAnOptionCounts) {
    const RenderArguments a = parse(
        {"s.yaml", "-o",       "a.exr", "--spp",      "4",         "--plan", "general",   "-c",    "a",  "--spp=8",
         "-r",     "1x1",      "-q",    "--plan",     "auto",      "-c",     "b",         "-q",    "-r", "3x2",
         "--fov",  "distance", "--fov", "half-width", "--gravity", "0,1,2",  "--gravity", "3,4,5", "-o", "b.exr"});
    EXPECT_EQ(a.overrides.spp, 8);
    EXPECT_EQ(a.overrides.width, 3);
    EXPECT_EQ(a.plan.camera, "b");
    EXPECT_FALSE(a.plan.general);
    EXPECT_TRUE(a.quiet);
    EXPECT_EQ(a.legacy.fov, LegacyOptions::Fov::half_width);
    EXPECT_EQ(a.legacy.gravity, (Vec3d{3, 4, 5}));
    EXPECT_EQ(a.outputs, (std::vector<std::string>{"a.exr", "b.exr"}));
}

TEST(ParseArguments, SaysWhatIsWrong) {
    const auto message = [](std::vector<std::string> line) -> std::string {
        line.insert(line.begin(), {"s.yaml", "-o", "a.exr"});
        try {
            parse(line);
        } catch (const Error& e) {
            return e.what();
        }
        return "fine";
    };
    for (const std::string text : {"16x", "x16", "16", "", "65537x1"})
        EXPECT_EQ(message({"-r", text}),
                  "error: bad value for --resolution" + (text.empty() ? text : " \"" + text + '"') +
                      "; expected WIDTHxHEIGHT in pixels, such as 640x480, each from 1 to 65536");
    for (const std::string text : {"b.png:x", "b.png:-1", "b.png:", ":1s2"})
        EXPECT_EQ(message({"--snapshot", text}), "error: bad value for --snapshot \"" + text +
                                                     "\"; expected FILE or FILE:SECONDS, such as preview.png:10");
}

TEST(ParseArguments, RefusesWhatIsWrong) {
    const std::vector<std::string> tails[] = {
        {"--frobnicate"},
        {"other.yaml"},
        {"--scene", "other.yaml"},
        {"--spp", "0"},
        {"--spp", "-4"},
        {"--spp", "1e3"},
        {"--spp", "16777217"},
        {"--spp", ""},
        {"--spp"},
        {"--seed", "-1"},
        {"--seed", "4294967296"},
        {"--seed", "1.5"},
        {"--max-depth", "-1"},
        {"--max-depth", "10001"},
        {"--threads", "-1"},
        {"--threads", "1025"},
        {"--threads", "two"},
        {"-r", "640"},
        {"-r", "x"},
        {"-r", ""},
        {"-r", "0x480"},
        {"-r", "640x-1"},
        {"-r", "640x480x3"},
        {"-r", "6.5x4"},
        {"-r", "65537x1"},
        {"--exposure", "nan"},
        {"--exposure", "inf"},
        {"--exposure", "1,5"},
        {"--time-limit", "0"},
        {"--time-limit", "-1"},
        {"--time-limit", "10x"},
        {"--time-limit", "10ms"},
        {"--time-limit", "nan"},
        {"--time-limit", "s"},
        {"--frame", "-1"},
        {"--frame", "1-2"},
        {"--frame", ""},
        {"--frames", "1,,2"},
        {"--frames", "3-1"},
        {"--frames", ""},
        {"--frame", "1", "--frames", "1-2"},
        {"--plan", "best"},
        {"--precision", "half"},
        {"--progress", "json"},
        {"--missing-textures", "ignore"},
        {"-o", "-"},
        {"-o", ""},
        {"--fov", "wide"},
    };
    for (std::vector<std::string> line : tails) {
        line.insert(line.begin(), {"scene.yaml", "-o", "a.exr"});
        try {
            parse(line);
            ADD_FAILURE() << testing::PrintToString(line);
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::usage) << testing::PrintToString(line);
        }
    }
}

}  // namespace
}  // namespace drt
