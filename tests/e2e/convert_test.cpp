// drt-convert as a user runs it.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>

#include "drt/base/constants.h"
#include "drt/formats/formats.h"
#include "support/process.h"

namespace drt {
namespace {

using test::ProcessOptions;
using test::ProcessResult;
using test::read_bytes;
using test::TempFolder;

const std::string example = DRT_TEST_DATA "/manual_example.txt";

ProcessResult convert(const std::vector<std::string>& arguments, const ProcessOptions& options = {}) {
    return test::run_process(DRT_CONVERT, arguments, options);
}

size_t count_files(const TempFolder& folder) {
    size_t n = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++n;
    return n;
}

TEST(Convert, ExampleBecomesTheSameScene) {
    const TempFolder folder;
    const ProcessResult r = convert({example, "-o", folder.file("scene.yaml")});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, "");
    EXPECT_TRUE(read_yaml_scene(folder.file("scene.yaml")).scene == read_legacy_scene(example).scene);
    EXPECT_EQ(count_files(folder), 1u);
}

TEST(Convert, TellsDefaultsAndAssumptionsOnStderrAndInTheFile) {
    const TempFolder folder;
    const ProcessResult r = convert({example, "-o", folder.file("scene.yaml")});
    const std::string yaml = read_bytes(folder.file("scene.yaml"));
    for (const std::string words :
         {"default used: phong_info diffuse_refraction = 0 (BallRed, BilliardTable)", "assumed: gravity 0 -9.81 0",
          "assumed: density 1", "assumed: impulse = force * 0.05 s", "assumed: angle of view = 2 atan(FOV / 2)",
          "assumed: ambient light 0.12", "the scene has no lights"}) {
        EXPECT_NE(r.err.find(words), std::string::npos) << words << "\nnot in\n" << r.err;
        EXPECT_NE(yaml.find(words), std::string::npos) << words << "\nnot in\n" << yaml;
    }
    EXPECT_EQ(yaml.find('#'), 0u);
}

/// What the format leaves open and drt's own defaults happen to equal is written all the same (model.md section 6).
TEST(Convert, AssumedGravityAndDensityAreInTheFile) {
    const ProcessResult r = convert({example, "-o", "-"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_NE(r.out.find("\ngravity: [0, -9.81, 0]\n"), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\n      density: 1\n"), std::string::npos) << r.out;
}

TEST(Convert, MissingTextureIsOnlyAWarning) {
    const ProcessResult r = convert({example, "-o", "-"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_NE(r.err.find(example + ":29:14: warning: the texture file does not exist"), std::string::npos) << r.err;
}

TEST(Convert, PresentTextureIsNoWarning) {
    const TempFolder folder;
    folder.write("textures/ball_red.tga", "any bytes: it is not opened");
    const std::string scene = folder.write("scene.txt", read_bytes(example));
    const ProcessResult r = convert({scene, "-o", "-"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err.find("does not exist"), std::string::npos) << r.err;
}

TEST(Convert, DashIsStandardOutput) {
    const TempFolder folder;
    const ProcessResult r = convert({example, "-o", "-"}, {.folder = folder.path().string(), .stdout_file = {}});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_TRUE(read_yaml_scene(folder.write("a.yaml", r.out)).scene == read_legacy_scene(example).scene);
}

TEST(Convert, QuietSaysNothingButErrors) {
    const TempFolder folder;
    EXPECT_EQ(convert({example, "-q", "-o", folder.file("a.yaml")}).err, "");
    const ProcessResult bad = convert({folder.write("b.txt", "plane a { }\nspher b { }\n"), "--quiet", "-o", "-"});
    EXPECT_EQ(bad.exit_code, 3);
    EXPECT_EQ(bad.err.find("default used"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find("b.txt:2:1: error: unknown element \"spher\""), std::string::npos) << bad.err;
}

TEST(Convert, EveryAssumptionIsAnOption) {
    const TempFolder folder;
    const ProcessResult r =
        convert({example, "-o", folder.file("a.yaml"), "--fov", "distance", "--gravity", "0,-1.62,-0.5",
                 "--density=2.5", "--legacy-step", "0.01", "--ambient-light", "0.25", "--add-lights"});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    const SceneDesc s = read_yaml_scene(folder.file("a.yaml")).scene;
    EXPECT_EQ(s.cameras[0].fov_degrees_start, degrees(2 * std::atan(1 / 2.5)));
    EXPECT_EQ(s.gravity, (Vec3d{0, -1.62, -0.5}));
    EXPECT_EQ(s.bodies[0].physics->density, 2.5);
    EXPECT_EQ(s.bodies[0].physics->impulses[0].impulse, (Vec3d{1000, 0, 0}));
    EXPECT_EQ(s.ambient_light, Color(0.25f));
    EXPECT_EQ(s.lights.size(), 1u);
}

TEST(Convert, NormalisesYaml) {
    const TempFolder folder;
    ASSERT_EQ(convert({example, "-o", folder.file("a.yaml")}).exit_code, 0);
    const ProcessResult r = convert({folder.file("a.yaml"), "-o", folder.file("b.yaml")});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_TRUE(read_yaml_scene(folder.file("a.yaml")).scene == read_yaml_scene(folder.file("b.yaml")).scene);
}

TEST(Convert, WrongCommandLinesAreUsageErrors) {
    const TempFolder folder;
    const std::string out = folder.file("a.yaml");
    const std::vector<std::string> lines[] = {
        {},
        {example},
        {"-o", out},
        {example, "-o", out, "--frobnicate"},
        {example, "-o", out, "--fov", "wide"},
        {example, "-o", out, "--gravity", "0,-9.81"},
        {example, "-o", out, "--gravity", "0,nan,0"},
        {example, "-o", out, "--gravity", "0,1,2,3"},
        {example, "-o", out, "--density", "0"},
        {example, "-o", out, "--legacy-step", "-1"},
        {example, "-o", out, "--ambient-light", "1,5"},
        {example, "extra.txt", "-o", out},
    };
    for (const auto& line : lines) {
        const ProcessResult r = convert(line);
        EXPECT_EQ(r.exit_code, 2) << testing::PrintToString(line) << '\n' << r.err;
        EXPECT_EQ(r.err.find("error: "), 0u) << testing::PrintToString(line) << '\n' << r.err;
    }
    EXPECT_EQ(count_files(folder), 0u);
}

TEST(Convert, HelpAndVersion) {
    const ProcessResult help = convert({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char* option : {"--output", "--quiet", "--fov", "--gravity", "--density", "--legacy-step",
                               "--ambient-light", "--add-lights", "Exit codes"})
        EXPECT_NE(help.out.find(option), std::string::npos) << option << '\n' << help.out;
    EXPECT_EQ(convert({"--version"}).out.find("drt-convert "), 0u);
}

TEST(Convert, InvalidScenesLeaveTheOutputAlone) {
    const TempFolder folder;
    const std::string out = folder.write("a.yaml", "precious");
    const ProcessResult r = convert({folder.write("bad.txt", "sphere a { radius x }"), "-o", out});
    EXPECT_EQ(r.exit_code, 3);
    EXPECT_NE(r.err.find("bad.txt:1:19: error: not a number \"x\"; expected a number > 0"), std::string::npos) << r.err;
    EXPECT_EQ(read_bytes(out), "precious");
}

TEST(Convert, MissingInput) {
    const TempFolder folder;
    const ProcessResult r = convert({folder.file("none.txt"), "-o", folder.file("a.yaml")});
    EXPECT_EQ(r.exit_code, 4);
    EXPECT_NE(r.err.find("No such file"), std::string::npos) << r.err;
    EXPECT_EQ(convert({folder.path().string(), "-o", folder.file("a.yaml")}).exit_code, 4);
}

TEST(Convert, UnwritableOutput) {
    const TempFolder folder;
    for (const std::string& out : {folder.file("none/a.yaml"), folder.path().string(), std::string("/dev/full")}) {
        const ProcessResult r = convert({example, "-o", out});
        EXPECT_EQ(r.exit_code, 5) << out << '\n' << r.err;
        EXPECT_NE(r.err.find("error: cannot write"), std::string::npos) << r.err;
    }
    EXPECT_EQ(convert({example, "-o", "-"}, {.folder = {}, .stdout_file = "/dev/full"}).exit_code, 5);
}

TEST(Convert, NeverOverwritesItsInput) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.txt", read_bytes(example));
    std::filesystem::create_symlink(scene, folder.path() / "link.yaml");
    for (const std::string& out : {scene, folder.file("./scene.txt"), folder.file("link.yaml")})
        EXPECT_EQ(convert({scene, "-o", out}).exit_code, 2) << out;
    EXPECT_EQ(read_bytes(scene), read_bytes(example));
}

TEST(Convert, ReplacesAnOldOutput) {
    const TempFolder folder;
    const std::string out = folder.write("a.yaml", "old");
    EXPECT_EQ(convert({example, "-o", out}).exit_code, 0);
    EXPECT_TRUE(read_yaml_scene(out).scene == read_legacy_scene(example).scene);
    EXPECT_EQ(count_files(folder), 1u);
}

}  // namespace
}  // namespace drt
