// Scenes and textures that are wrong or missing, and what --check and --explain say about a scene.
#include "render_programs.h"

namespace drt {
namespace {

const std::string example = DRT_TEST_DATA "/manual_example.txt";

class RenderScene : public testing::Test {
protected:
    ProcessResult run(const std::string& scene, std::vector<std::string> options = {}) {
        options.insert(options.begin(), {scene, "-r", "8x6", "--spp", "1"});
        return render(options);
    }

    TempFolder folder_;
    std::string scene_ = folder_.write("scene.yaml", small_scene);
    std::string out_ = folder_.file("a.exr");
};

TEST_F(RenderScene, MissingTextureIsFoundWhereItIsNamed) {
    const ProcessResult r = run(example, {"-o", out_});
    EXPECT_EQ(r.exit_code, 4);
    EXPECT_TRUE(contains(r.err, example + ":29:14: error: "));
    EXPECT_TRUE(contains(r.err, "No such file"));
    EXPECT_EQ(r.err.find("ball_red.tga"), r.err.rfind("ball_red.tga")) << r.err;
    EXPECT_FALSE(std::filesystem::exists(out_));
    EXPECT_EQ(run(example, {"--check"}).exit_code, 4);
}

TEST_F(RenderScene, MissingTextureMayBeAChecker) {
    const ProcessResult r = run(example, {"-o", out_, "--missing-textures", "checker", "--frames", "0-1"});
    EXPECT_EQ(r.exit_code, 0);
    const size_t warning = r.err.find(example + ":29:14: warning: ");
    EXPECT_NE(warning, std::string::npos) << r.err;
    EXPECT_EQ(r.err.find(":29:14: warning: ", warning + example.size() + 1), std::string::npos)
        << "told twice: " << r.err;
    EXPECT_EQ(read_image_raw(folder_.file("a.0001.exr")).width, 8);
}

TEST_F(RenderScene, InvalidScenesTellAllThatIsWrong) {
    std::string bad = small_scene;
    bad.replace(bad.find("radius: 1"), 9, "radius: -1");
    bad.replace(bad.find("fov_degrees"), 11, "fov_degree");
    const std::string path = folder_.write("bad.yaml", bad);
    for (const std::vector<std::string>& options : {std::vector<std::string>{"-o", out_}, {"--check"}}) {
        const ProcessResult r = run(path, options);
        EXPECT_EQ(r.exit_code, 3);
        EXPECT_TRUE(contains(r.err, path + ":8:"));
        EXPECT_TRUE(contains(r.err, "did you mean \"fov_degrees\"?"));
    }
    EXPECT_FALSE(std::filesystem::exists(out_));
}

TEST_F(RenderScene, YamlOfAnotherNameIsToldToBeLegacy) {
    const std::string path = folder_.write("scene.drt", small_scene);
    const ProcessResult r = run(path, {"--check"});
    EXPECT_EQ(r.exit_code, 3);
    const std::string note = path + ": note: read as a legacy scene: its name does not end in .yaml or .yml\n";
    EXPECT_EQ(r.err.find(note), r.err.size() - note.size()) << r.err;
}

TEST_F(RenderScene, MissingSceneIsAMissingInput) {
    EXPECT_EQ(run(folder_.file("none.yaml"), {"-o", out_}).exit_code, 4);
    EXPECT_EQ(run(folder_.path().string(), {"-o", out_}).exit_code, 4);
}

TEST_F(RenderScene, CameraIsChosenByName) {
    EXPECT_EQ(run(scene_, {"-o", out_, "--camera", "main"}).exit_code, 0);
    const ProcessResult r = run(scene_, {"-o", out_, "-c", "mian"});
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_TRUE(contains(r.err, "no such camera \"mian\"; expected one of: main; did you mean \"main\"?"));
}

TEST_F(RenderScene, FramesThatNobodyRecordsAreFoundBeforeRendering) {
    const ProcessResult r = run(scene_, {"-o", out_, "--frames", "8-11"});
    EXPECT_EQ(r.exit_code, 2);
    EXPECT_TRUE(contains(r.err, "no camera records frame 10 (video time 1 s): camera \"main\" records frames 0..9"));
    EXPECT_EQ(files_in(folder_), std::vector<std::string>{"scene.yaml"});
    EXPECT_EQ(run(scene_, {"-o", out_, "-f", "9"}).exit_code, 0);
}

TEST_F(RenderScene, CheckRendersNothing) {
    const ProcessResult r = run(scene_, {"--check", "-o", out_});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.out, "");
    EXPECT_EQ(r.err, "ok: " + scene_ + " (bodies: 2, lights: 1, cameras: 1, frames: 1)\n");
    const ProcessResult quiet = run(scene_, {"--check", "--quiet"});
    EXPECT_EQ(quiet.out + quiet.err, "");
    EXPECT_FALSE(std::filesystem::exists(out_));
    EXPECT_EQ(run(scene_, {"--check", "-o", folder_.file("none/a.exr")}).exit_code, 5);
    EXPECT_EQ(run(scene_, {"--check", "--frame", "10"}).exit_code, 2);
}

TEST_F(RenderScene, ExplainListsWhatWasLeftOutAndWhy) {
    const ProcessResult r = run(scene_, {"--explain"});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err, "");
    EXPECT_TRUE(contains(r.out, "left out   lens                     aperture radius is 0: a pinhole\n"));
    EXPECT_TRUE(contains(r.out, "kept       lights "));
    const ProcessResult general = run(scene_, {"--explain", "--plan", "general"});
    EXPECT_EQ(general.out.find("left out   lens"), std::string::npos) << general.out;
    const ProcessResult frames = run(scene_, {"--explain", "--frames", "0-1", "-o", out_, "--quiet"});
    EXPECT_EQ(frames.out, "frame 0:\n" + r.out + "frame 1:\n" + r.out);
    EXPECT_EQ(frames.err, "");
}

}  // namespace
}  // namespace drt
