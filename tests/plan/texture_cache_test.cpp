// Textures are read once, however many frames show them.
#include "drt/plan/texture_cache.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>

#include "plan_parts.h"

namespace drt {
namespace {

namespace fs = std::filesystem;

class Textures : public testing::Test {
protected:
    Textures() {
        std::string name = (fs::temp_directory_path() / "drt_textures_XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        write_image(file("wood.png"), Image(4, 2, 3));
        scene_ = test::scene_with(sphere({0, 0, -5}, 1));
        scene_.textures = {{"wood", file("wood.png"), {}}};
        scene_.materials[0].texture = "wood";
    }
    ~Textures() override { fs::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    static const TextureMap* texture(const RenderPlan& plan) {
        return &std::get<std::unique_ptr<World<float>>>(plan.world)->textures[0];
    }

    fs::path folder_;
    SceneDesc scene_;
};

TEST_F(Textures, AreReadForTheFirstFrameOnly) {
    RenderPlan first, second;
    {
        TextureCache cache;
        first = compile(scene_, {}, cache);
        fs::remove(file("wood.png"));
        PlanOptions options;
        options.frame = 1;
        second = compile(scene_, options, cache);
    }
    EXPECT_EQ(texture(first), texture(second));
    EXPECT_EQ(texture(second)->levels.front().width, 4);  // without the cache
    EXPECT_THROW(compile(scene_, {}), Error);
}

TEST_F(Textures, OfOneFileDifferByTheirTransfer) {
    using Transfer = ReadOptions::Transfer;
    TextureCache cache;
    const auto srgb = cache.get(file("wood.png"), Transfer::srgb).map;
    EXPECT_EQ(cache.get(file("wood.png"), Transfer::srgb).map, srgb);
    EXPECT_NE(cache.get(file("wood.png"), Transfer::linear).map, srgb);
}

TEST_F(Textures, ThatCannotBeReadStayUnreadable) {
    const std::string missing = file("none.png");
    scene_.textures[0].file = missing;
    TextureCache cache;
    for (int frame = 0; frame < 2; ++frame) {
        PlanOptions options;
        try {
            compile(scene_, options, cache);
            FAIL();
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::asset);
            EXPECT_STREQ(e.what(), ("error: texture \"wood\": cannot read image \"" + missing +
                                    "\": No such file or directory; expected an image file (--missing-textures checker "
                                    "renders without)")
                                       .c_str());
        }
        options.checker_for_missing_textures = true;
        const RenderPlan plan = compile(scene_, options, cache);
        ASSERT_EQ(plan.notes.size(), 1u);
        EXPECT_EQ(to_string(plan.notes[0]), "warning: texture \"wood\": cannot read image \"" + missing +
                                                "\": No such file or directory (a checker stands in)");
        write_image(missing, Image(1, 1, 3));  // too late
    }
}

}  // namespace
}  // namespace drt
