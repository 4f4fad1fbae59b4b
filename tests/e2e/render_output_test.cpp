// Output that cannot be written, and standard streams that are not there.
#include "render_programs.h"

namespace drt {
namespace {

// Would render for a day: what is found out in the time these tests have was found out before rendering.
const std::vector<std::string> endless{"--spp", "16777216", "-r", "4096x4096"};

class RenderOutput : public testing::Test {
protected:
    std::vector<std::string> arguments(const std::vector<std::string>& options) const {
        std::vector<std::string> all{scene_};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    void expect_picture(const std::string& path) const {
        const Image image = read_image_raw(path);
        EXPECT_EQ(image.width, 24);
        EXPECT_EQ(image.height, 16);
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("scene.yaml", small_scene);
    std::string out_ = folder_.file("a.exr");
};

TEST_F(RenderOutput, UnwritablePathsAreFoundBeforeRendering) {
    std::filesystem::create_directory(folder_.path() / "folder.exr");
    std::filesystem::create_symlink("/dev/full", folder_.path() / "full.exr");
    for (const std::string& path : {folder_.file("none/a.exr"), folder_.file("folder.exr"), folder_.file("full.exr"),
                                    std::string("/proc/a.exr"), scene_ + "/a.exr"}) {
        std::vector<std::string> line = arguments(endless);
        line.insert(line.end(), {"-o", path});
        const ProcessResult r = render(line, {.folder = {}, .stdout_file = {}, .timeout = 20});
        EXPECT_EQ(r.exit_code, 5) << path << '\n' << r.err;
        EXPECT_TRUE(contains(r.err, "error: cannot write image \"" + path + "\": "));
    }
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"folder.exr", "full.exr", "scene.yaml"}));
}

TEST_F(RenderOutput, AMissingFolderIsCalledSo) {
    std::vector<std::string> line = arguments(endless);
    line.insert(line.end(), {"-o", folder_.file("none/a.png")});
    EXPECT_EQ(render(line).err, "error: cannot write image \"" + folder_.file("none/a.png") + "\": the folder \"" +
                                    folder_.file("none") + "\" does not exist\n");
}

TEST_F(RenderOutput, UnwritableSnapshotsAndLaterFramesToo) {
    std::filesystem::create_directory(folder_.path() / "b.0007.exr");
    for (const std::vector<std::string>& output :
         {std::vector<std::string>{"-o", out_, "--snapshot", folder_.file("none/s.png:5")},
          {"-o", out_, "-o", folder_.file("none/b.png")},
          {"-o", folder_.file("b.exr"), "--frames", "0-9"}}) {
        std::vector<std::string> line = arguments(endless);
        line.insert(line.end(), output.begin(), output.end());
        EXPECT_EQ(render(line, {.folder = {}, .stdout_file = {}, .timeout = 20}).exit_code, 5);
    }
}

TEST_F(RenderOutput, AFullDiskLeavesTheOldPicture) {
    folder_.write("a.exr", "precious");
    const ProcessResult r =
        render_in_shell("ulimit -f 4 && exec \"$0\" \"$@\"", arguments({"-r", "64x48", "-o", out_}));
    EXPECT_EQ(r.exit_code, 5) << r.err;
    EXPECT_TRUE(contains(r.err, "cannot write image \"" + out_ + "\": File too large"));
    EXPECT_EQ(read_bytes(out_), "precious");
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"a.exr", "scene.yaml"}));
}

TEST_F(RenderOutput, OneFailureDoesNotCostTheOtherPicture) {
    const std::string png = folder_.file("b.png");
    const ProcessResult r =
        render_in_shell("ulimit -f 6 && exec \"$0\" \"$@\"", arguments({"-r", "24x16", "-o", out_, "-o", png}));
    EXPECT_EQ(r.exit_code, 5) << r.err;
    EXPECT_EQ(read_image(png).width, 24);
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"b.png", "scene.yaml"}));
}

TEST_F(RenderOutput, ReplacesAnOldPictureAndNothingElse) {
    folder_.write("a.exr", "old");
    folder_.write("a.exr.tmp.999999999.0", "of another machine, perhaps");
    ASSERT_EQ(render(arguments({"-o", out_})).exit_code, 0);
    expect_picture(out_);
    EXPECT_EQ(files_in(folder_), (std::vector<std::string>{"a.exr", "a.exr.tmp.999999999.0", "scene.yaml"}));
}

TEST_F(RenderOutput, ADanglingLinkStaysAndIsOneOutput) {
    std::filesystem::create_symlink("b.exr", out_);
    EXPECT_EQ(render(arguments({"-o", out_, "-o", folder_.file("b.exr")})).exit_code, 2);
    ASSERT_EQ(render(arguments({"-o", out_})).exit_code, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(out_));
    expect_picture(folder_.file("b.exr"));
}

TEST_F(RenderOutput, QuietSaysNothing) {
    const ProcessResult r = render(arguments({"-o", out_, "--quiet", "--verbose", "--progress", "bar"}));
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.out + r.err, "");
    EXPECT_NE(render(arguments({"-o", scene_, "--quiet"})).err, "");
}

TEST_F(RenderOutput, VerboseTellsTheTimeOfTheStages) {
    const std::string normal = render(arguments({"-o", out_})).err;
    EXPECT_TRUE(contains(normal, "wrote " + out_));
    EXPECT_TRUE(contains(normal, "all samples taken: 4 spp in "));
    EXPECT_TRUE(contains(normal, "estimated error "));
    EXPECT_TRUE(contains(normal, "rays/s"));
    EXPECT_EQ(normal.find("stages ("), std::string::npos) << normal;
    EXPECT_TRUE(contains(render(arguments({"-o", out_, "-v"})).err, "stages ("));
}

TEST_F(RenderOutput, ClosedStreamsNeitherHurtNorEnterThePicture) {
    for (const char* closed : {">&-", "2>&-", "<&-", "<&- >&- 2>&-"}) {
        const ProcessResult r = render_in_shell(std::string("exec \"$0\" \"$@\" ") + closed, arguments({"-o", out_}));
        EXPECT_EQ(r.exit_code, 0) << closed << '\n' << r.err;
        expect_picture(out_);
        std::filesystem::remove(out_);
    }
}

TEST_F(RenderOutput, ALogThatCannotBeWrittenCostsNoPicture) {
    const std::string command =
        "{ sleep 0.2; \"$0\" \"$@\" 2>&1; echo $? > status; } | true; "
        "while [ ! -s status ]; do sleep 0.01; done; exit $(cat status)";
    const ProcessResult pipe = render_in_shell(command, arguments({"-o", out_, "-v"}),
                                               {.folder = folder_.path().string(), .stdout_file = {}, .timeout = 30});
    EXPECT_EQ(pipe.exit_code, 0) << pipe.signal;
    expect_picture(out_);
    EXPECT_EQ(render_in_shell("exec \"$0\" \"$@\" 2> /dev/full", arguments({"-o", out_, "-v"})).exit_code, 0);
    EXPECT_EQ(render_in_shell("exec \"$0\" \"$@\" 2> /dev/full", arguments({"-o", scene_})).exit_code, 2);
}

TEST_F(RenderOutput, TextForTheStandardOutputMustArrive) {
    for (const std::vector<std::string>& line : {arguments({"--explain"}), {"--help"}, {"--version"}}) {
        EXPECT_EQ(render(line, {.folder = {}, .stdout_file = "/dev/full"}).exit_code, 5);
        const ProcessResult r = render_in_shell("exec \"$0\" \"$@\" >&-", line);
        EXPECT_EQ(r.exit_code, 5);
        EXPECT_TRUE(contains(r.err, "error: cannot write to the standard output: "));
    }
}

}  // namespace
}  // namespace drt
