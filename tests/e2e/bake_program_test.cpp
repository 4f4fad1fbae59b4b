// drt-bake as a user runs it.

#include <gtest/gtest.h>

#include <cstdlib>

#include "drt/formats/formats.h"
#include "physics_scene.h"
#include "render_programs.h"

namespace drt {
namespace {

ProcessResult bake(const std::vector<std::string>& arguments) { return test::run_process(DRT_BAKE, arguments); }

TEST(BakeProgram, WritesKeyframesThatRenderTheSameBits) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene), baked = folder.file("baked.yaml");
    const ProcessResult r = bake({scene, "-o", baked});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.out, "");
    EXPECT_TRUE(contains(r.err, "2 dynamic bodies from t = 0 s to 2 s"));
    EXPECT_TRUE(contains(r.err, "trusted"));
    const std::string text = read_bytes(baked);
    EXPECT_EQ(text.find("physics"), std::string::npos);
    EXPECT_TRUE(contains(text, "# Baked by drt-bake"));
    EXPECT_TRUE(contains(text, "orientation: "));
    for (const std::string frame : {"0", "6", "19"}) {
        const Image a = render_exr(folder, "scene" + frame, {scene, "-f", frame, "--no-bake-cache"});
        const Image b = render_exr(folder, "baked" + frame, {baked, "-f", frame});
        EXPECT_EQ(a.data, b.data) << "frame " << frame;
    }
    EXPECT_NE(read_image_raw(folder.file("scene0.exr")).data, read_image_raw(folder.file("scene6.exr")).data);
}

TEST(BakeProgram, LeavesASceneWithoutPhysicsAsItIs) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", small_scene), baked = folder.file("baked.yaml");
    const ProcessResult r = bake({scene, "-o", baked, "--quiet"});
    ASSERT_EQ(r.exit_code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_EQ(read_yaml_scene(baked).scene, read_yaml_scene(scene).scene);
}

TEST(BakeProgram, AsksHowLong) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", replaced(physics_scene, "video_end: 2, ", ""));
    const ProcessResult r = bake({scene, "-o", folder.file("baked.yaml")});
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_TRUE(contains(r.err, "--until"));
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"scene.yaml"}));
    const ProcessResult told = bake({scene, "-o", folder.file("baked.yaml"), "--until", "0.7"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    EXPECT_TRUE(contains(told.err, "to 1 s"));
}

TEST(BakeProgram, EndsInTime) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", replaced(physics_scene, "video_end: 2, ", ""));
    const std::string lasting = folder.write("lasting.yaml", replaced(physics_scene, "video_end: 2", "video_end: 1e9"));
    for (const std::string until : {"1e308", "-1e308", "1.1e6", "inf"}) {
        const ProcessResult r = bake({scene, "-o", folder.file("baked.yaml"), "--until", until});
        EXPECT_EQ(r.exit_code, 2) << until;
        EXPECT_TRUE(contains(r.err, "expected a number of at most 1e+06 in size, not \"" + until + '"'));
    }
    const ProcessResult r = bake({lasting, "-o", folder.file("baked.yaml")});
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_TRUE(contains(r.err, "Cameras show it until t = 1e+09 s, too long to simulate; give --until"));
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"lasting.yaml", "scene.yaml"}));
}

TEST(BakeProgram, WritesNothingThatCannotBeRead) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", R"(drt: 1
simulation: {end: 100, tolerance: 1e6}
materials: [{name: grey}]
bodies:
  - {type: sphere, radius: 1e12, material: grey, physics: {mass: 1, velocity: [1e14, 0, 0]}}
cameras: [{position: [0, 0, 1e13]}]
)");
    const ProcessResult r = bake({scene, "-o", folder.file("baked.yaml")});
    EXPECT_EQ(r.exit_code, 3);
    EXPECT_TRUE(contains(r.err, "scene.yaml:5:5: error: position is too large \"[1"));
    EXPECT_TRUE(contains(r.err, "note: this is of the motion as it was computed\n"));
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"scene.yaml"}));
}

TEST(BakeProgram, SaysWhatIsWrongAndHow) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene), out = folder.file("out.yaml");
    const std::string wrong = folder.write("wrong.yaml", replaced(physics_scene, "mass: 2", "mass: -2"));
    const auto exit_code = [&](const std::vector<std::string>& arguments) { return bake(arguments).exit_code; };
    EXPECT_EQ(exit_code({}), 2);
    EXPECT_EQ(exit_code({scene}), 2);
    EXPECT_EQ(exit_code({scene, "-o", scene}), 2);
    EXPECT_EQ(exit_code({scene, "-o", out, "--until", "nan"}), 2);
    EXPECT_EQ(exit_code({wrong, "-o", out}), 3);
    EXPECT_TRUE(contains(bake({wrong, "-o", out}).err, "wrong.yaml:9:"));
    EXPECT_EQ(exit_code({folder.file("absent.yaml"), "-o", out}), 4);
    EXPECT_EQ(exit_code({scene, "-o", folder.file("absent/out.yaml")}), 5);
    EXPECT_EQ(read_bytes(scene), physics_scene);
    EXPECT_EQ(read_bytes(out), "");
}

TEST(BakeProgram, NeverOverwritesWhatTheSceneIsMadeOf) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", "drt: 1\ninclude: parts/common.yaml\n");
    const std::string common = replaced(physics_scene, "bodies:\n",
                                        "textures: [{name: wood, file: wood.png}]\nbodies:\n"
                                        "  - {name: set, type: sphere_set, file: balls.txt, material: red}\n");
    folder.write("parts/common.yaml", common);
    folder.write("parts/wood.png", "wood");
    folder.write("parts/balls.txt", "0 0 0 1\n");
    std::filesystem::create_symlink("parts/common.yaml", folder.path() / "link.yaml");
    for (const std::string name : {"parts/common.yaml", "parts/../parts/./common.yaml", "link.yaml", "parts/wood.png",
                                   "parts/balls.txt", "scene.yaml"}) {
        const ProcessResult r = bake({scene, "-o", folder.file(name)});
        EXPECT_EQ(r.exit_code, 2) << name << r.err;
        EXPECT_TRUE(contains(r.err, "error: the output "));
        const ProcessResult converted = test::run_process(DRT_CONVERT, {scene, "-o", folder.file(name)});
        EXPECT_EQ(converted.exit_code, 2) << name << converted.err;
    }
    EXPECT_EQ(read_bytes(folder.file("parts/common.yaml")), common);
    EXPECT_EQ(read_bytes(folder.file("parts/wood.png")), "wood");
    EXPECT_EQ(read_bytes(folder.file("parts/balls.txt")), "0 0 0 1\n");
}

TEST(BakeProgram, AsksForANameOfTheOutput) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene);
    for (const std::string& program : {std::string(DRT_BAKE), std::string(DRT_CONVERT)})
        for (const std::vector<std::string>& name : {std::vector<std::string>{"-o", ""}, {"--output="}}) {
            std::vector<std::string> line{scene};
            line.insert(line.end(), name.begin(), name.end());
            const ProcessResult r = test::run_process(program, line);
            EXPECT_EQ(r.exit_code, 2) << program << r.err;
            EXPECT_EQ(r.err.find("error: "), 0u) << program << r.err;
        }
}

// Would simulate for minutes: what is found out in the time this test has was found out before.
TEST(BakeProgram, FindsUnwritableOutputsBeforeItSimulates) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", endless_physics_scene());
    std::filesystem::create_directory(folder.path() / "folder.yaml");
    for (const std::string& out : {folder.file("none/out.yaml"), folder.file("folder.yaml"), folder.path().string(),
                                   scene + "/out.yaml", std::string("/proc/out.yaml")}) {
        const ProcessResult r =
            test::run_process(DRT_BAKE, {scene, "-o", out}, {.folder = {}, .stdout_file = {}, .timeout = 20});
        EXPECT_EQ(r.exit_code, 5) << out << r.err;
        EXPECT_TRUE(contains(r.err, "error: cannot write " + out + ": "));
    }
    EXPECT_EQ(files_in(folder), (std::vector<std::string>{"folder.yaml", "scene.yaml"}));
}

// Addresses differ from process to process (and the environment here): nothing may depend on them.
TEST(BakeProgram, WritesTheSameBitsInEveryProcess) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene);
    std::string first;
    for (int k = 0; k < 5; ++k) {
        setenv("DRT_TEST_PADDING", std::string(size_t(k) * 1000, 'x').c_str(), 1);
        const ProcessResult r = bake({scene, "-o", "-", "-q"});
        ASSERT_EQ(r.exit_code, 0) << r.err;
        if (k == 0) first = r.out;
        EXPECT_EQ(r.out, first) << k;
    }
    unsetenv("DRT_TEST_PADDING");
    EXPECT_TRUE(contains(first, "keys:"));
}

TEST(BakeProgram, WritesToTheStandardOutput) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene);
    const ProcessResult piped = bake({scene, "-o", "-", "-q"});
    EXPECT_EQ(piped.exit_code, 0);
    EXPECT_EQ(piped.err, "");
    EXPECT_TRUE(contains(piped.out, "keys:"));
}

}  // namespace
}  // namespace drt
