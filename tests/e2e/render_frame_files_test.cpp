// Several frames and the names of their files.
#include <algorithm>

#include "render_programs.h"

namespace drt {
namespace {

using Names = std::vector<std::string>;

class RenderFrames : public testing::Test {
protected:
    Names run(const std::string& pattern, std::vector<std::string> options) {
        const std::string scene = folder_.write("scene.yaml", small_scene);
        options.insert(options.begin(), {scene, "-r", "8x6", "--spp", "1", "-o", folder_.file(pattern)});
        const ProcessResult r = render(options);
        EXPECT_EQ(r.exit_code, 0) << r.err;
        Names names = files_in(folder_);
        std::erase(names, "scene.yaml");
        return names;
    }

    TempFolder folder_;
};

TEST_F(RenderFrames, HashesAreDigits) {
    EXPECT_EQ(run("a.####.exr", {"--frames", "0-4:2"}), (Names{"a.0000.exr", "a.0002.exr", "a.0004.exr"}));
    EXPECT_EQ(exr_attributes(folder_.file("a.0002.exr"))["drt:frame"], MetadataValue(2));
    EXPECT_NE(read_image_raw(folder_.file("a.0000.exr")).data, read_image_raw(folder_.file("a.0002.exr")).data)
        << "each frame has its own noise";
}

TEST_F(RenderFrames, PrintfTokenAndList) {
    EXPECT_EQ(run("a_%03d.exr", {"--frames", "7,1-2,7,2"}), (Names{"a_001.exr", "a_002.exr", "a_007.exr"}));
}

TEST_F(RenderFrames, WithoutATokenTheNumberIsInserted) {
    EXPECT_EQ(run("a.exr", {"--frames", "7,9"}), (Names{"a.0007.exr", "a.0009.exr"}));
}

TEST_F(RenderFrames, OneFrameKeepsItsName) {
    EXPECT_EQ(run("a.exr", {"--frame", "7"}), Names{"a.exr"});
    EXPECT_EQ(exr_attributes(folder_.file("a.exr"))["drt:frame"], MetadataValue(7));
}

TEST_F(RenderFrames, AFrameAloneIsTheFrameAmongOthers) {
    run("a.#.exr", {"--frames", "1-3"});
    run("b.exr", {"--frame", "2"});
    EXPECT_EQ(read_image_raw(folder_.file("a.2.exr")).data, read_image_raw(folder_.file("b.exr")).data);
}

TEST_F(RenderFrames, SnapshotsAreNumberedByTokenOnly) {
    EXPECT_EQ(run("a.exr", {"--frames", "1-2", "--snapshot", folder_.file("s.#.png")}),
              (Names{"a.0001.exr", "a.0002.exr", "s.1.png", "s.2.png"}));
    const Names names = run("a.exr", {"--frames", "1-2", "--snapshot", folder_.file("live.png")});
    EXPECT_EQ(std::count(names.begin(), names.end(), "live.png"), 1);
}

}  // namespace
}  // namespace drt
