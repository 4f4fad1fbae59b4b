// Command lines, right and wrong.
#include "render_programs.h"

namespace drt {
namespace {

TEST(RenderUsage, WrongCommandLinesSayWhatIsWrongAndWriteNothing) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", small_scene);
    // One of each kind; the others are told apart by the same code, whose own test is ParseArguments.
    const std::vector<std::string> tails[] = {
        {"--frobnicate"},
        {"--spp", "0"},
        {"--spp"},
        {"-r", "65536x65536"},
        {"--frames", "1,,2"},
        {"--camera", "none"},
        {"--fov", "wide"},
        {"-o", "-"},
        {"-o", folder.file("b.xyz")},
        {"-o", folder.file("b")},
        {"--snapshot", folder.file("b.png:1.x")},
    };
    for (std::vector<std::string> line : tails) {
        line.insert(line.begin(), {scene, "-o", folder.file("a.exr")});
        const ProcessResult r = render(line);
        EXPECT_EQ(r.exit_code, 2) << testing::PrintToString(line) << '\n' << r.err;
        EXPECT_EQ(r.err.find("error: "), 0u) << testing::PrintToString(line) << '\n' << r.err;
        EXPECT_EQ(r.out, "");
    }
    EXPECT_EQ(files_in(folder), std::vector<std::string>{"scene.yaml"});
}

TEST(RenderUsage, UnknownOptionsAreNamedWithTheNearest) {
    EXPECT_EQ(render({"a.yaml", "--sppp", "64", "-o", "a.exr"}).err,
              "error: unknown option \"--sppp\"; did you mean \"--spp\"?\n");
    EXPECT_EQ(render({"--sppp=64", "a.yaml", "-o", "a.exr"}).err,
              "error: unknown option \"--sppp\"; did you mean \"--spp\"?\n");
    EXPECT_EQ(render({"--thread", "1", "a.yaml", "--frobnicate"}).err,
              "error: unknown option \"--thread\"; did you mean \"--threads\"?\n");
    EXPECT_EQ(render({"a.yaml", "-x"}).err, "error: unknown option \"-x\"; expected one that --help lists\n");
    EXPECT_EQ(render({"a.yaml", "b.yaml", "c.yaml", "-o", "a.exr"}).err,
              "error: one word too many \"b.yaml\"; expected what --help lists\n");
}

TEST(RenderUsage, HelpSaysWhatIsAFileAndEveryTypeOfPicture) {
    const std::string help = render({"--help"}).out;
    EXPECT_EQ(help.find("TEXT"), std::string::npos) << help;
    for (const char* type : {".exr", ".tif", ".hdr", ".png", ".jpg", ".bmp", ".tga", ".ppm", ".webp", ".gif", ".dpx"})
        EXPECT_TRUE(contains(help, std::string(" ") + type + ' '));
}

// CLI11 2.4 refuses such a pair, and so the program would not start; older releases let it be.
TEST(RenderUsage, NoOptionHasTheNameOfThePositional) {
    const std::string help = render({"--help"}).out;
    ASSERT_TRUE(contains(help, "Usage: drt-render [OPTIONS] [file]"));
    EXPECT_EQ(help.find("--file"), std::string::npos) << help;
}

TEST(RenderUsage, SceneAndOutputAreNeeded) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", small_scene);
    EXPECT_TRUE(contains(render({}).err, "no scene file"));
    EXPECT_EQ(render({}).exit_code, 2);
    EXPECT_TRUE(contains(render({scene}).err, "no output file"));
    EXPECT_EQ(render({scene}).exit_code, 2);
}

TEST(RenderUsage, NeverOverwritesItsInputsOrItself) {
    const TempFolder folder;
    std::string textured = small_scene;
    textured += "textures:\n  - {name: wood, file: wood.png}\n";
    const std::string scene = folder.write("scene.yaml", textured), wood = folder.write("wood.png", "precious");
    folder.write("part.png", "drt: 1\n");
    folder.write("balls.png", "0 0 0 1\n");
    const std::string parted = folder.write("parted.yaml", small_scene + "include: part.png\n");
    const std::string set =
        folder.write("set.yaml", replaced(small_scene, "type: plane", "type: sphere_set, file: balls.png"));
    const std::string png_scene = folder.write("legacy.png", "settings { }");
    std::filesystem::create_symlink(scene, folder.path() / "link.png");
    std::filesystem::create_directory_symlink(folder.path(), folder.path() / "here");
    const std::string a = folder.file("a.png");
    const std::vector<std::string> lines[] = {
        {scene, "-o", scene},
        {scene, "-o", folder.file("link.png")},
        {scene, "-o", wood},
        {scene, "-o", folder.file("here/wood.png")},
        {scene, "-o", ""},
        {parted, "-o", folder.file("part.png")},
        {set, "-o", folder.file("balls.png")},
        {scene, "-o", a, "--snapshot", wood},
        {scene, "-o", a, "--snapshot", folder.file("here/a.png:5")},
        {scene, "-o", folder.file("#.png"), "--snapshot", folder.file("1.png"), "--frames", "0-1"},
        {png_scene, "-o", folder.file("./legacy.png")},
        {scene, "-o", a, "-o", a},
        {scene, "-o", a, "-o", folder.file("here/./a.png")},
        {scene, "-o", folder.file("#.png"), "-o", folder.file("%d.png"), "--frames", "0-1"},
    };
    for (const auto& line : lines) {
        const ProcessResult r = render(line);
        EXPECT_EQ(r.exit_code, 2) << testing::PrintToString(line) << '\n' << r.err;
    }
    EXPECT_EQ(read_bytes(wood), "precious");
    EXPECT_EQ(read_bytes(folder.file("part.png")), "drt: 1\n");
    EXPECT_EQ(read_bytes(folder.file("balls.png")), "0 0 0 1\n");
    EXPECT_EQ(read_bytes(scene), textured);
    EXPECT_FALSE(std::filesystem::exists(a));
}

TEST(RenderUsage, HelpListsEveryOptionAndTheExitCodes) {
    const ProcessResult r = render({"--help"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err, "");
    for (const char* option : {"--output",
                               "--resolution",
                               "--exposure",
                               "--snapshot",
                               "--frame",
                               "--frames",
                               "--camera",
                               "--preview",
                               "--scene",
                               "--spp",
                               "--time-limit",
                               "--seed",
                               "--max-depth",
                               "--missing-textures",
                               "--threads",
                               "--plan",
                               "--precision",
                               "--explain",
                               "--check",
                               "--progress",
                               "--quiet",
                               "--verbose",
                               "--version",
                               "--fov",
                               "--gravity",
                               "--density",
                               "--legacy-step",
                               "--ambient-light",
                               "--add-lights",
                               "Exit codes: 0 done",
                               "75 stopped by SIGTERM",
                               "standard output) is refused"})
        EXPECT_TRUE(contains(r.out, option));
}

TEST(RenderUsage, VersionIsOneLine) {
    const ProcessResult r = render({"--version"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.out.find("drt-render "), 0u);
    EXPECT_EQ(r.out.find('\n'), r.out.size() - 1);
}

}  // namespace
}  // namespace drt
