// drt-render and scenes with physics.

#include <gtest/gtest.h>

#include "physics_scene.h"
#include "render_programs.h"

namespace drt {
namespace {

// What the dynamic linker opened is told to the standard error.
std::string loaded_libraries(const std::vector<std::string>& arguments) {
    const ProcessResult r = render_in_shell("LD_DEBUG=files \"$0\" \"$@\"", arguments);
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_TRUE(contains(r.err, "libembree"));  // so that it does tell
    return r.err;
}

TEST(RenderPhysics, LoadsBulletOnlyForSceneWithPhysics) {
    const TempFolder folder;
    const std::string plain = folder.write("plain.yaml", small_scene);
    const std::string physics = folder.write("physics.yaml", physics_scene);
    const std::string without = loaded_libraries({plain, "--check"});
    EXPECT_EQ(without.find("ullet"), std::string::npos);
    const std::string with = loaded_libraries({physics, "--check", "--no-bake-cache"});
    EXPECT_TRUE(contains(with, "libdrt-bullet.so"));
    EXPECT_TRUE(contains(with, "libBulletCollision-float64.so"));
}

class RenderPhysicsCache : public testing::Test {
protected:
    // What is said of the cache.
    std::string check(const std::string& text, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{folder.write("scene.yaml", text), "--check", "-v", "--bake-cache", cache};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult r = render(arguments);
        EXPECT_EQ(r.exit_code, 0) << r.err;
        return r.err;
    }
    std::string kept_file() const { return std::filesystem::directory_iterator(cache)->path().string(); }

    TempFolder folder;
    std::string cache = folder.file("cache/drt");
};

TEST_F(RenderPhysicsCache, IsFoundUntilWhatMattersChanges) {
    EXPECT_TRUE(contains(check(physics_scene), "physics: computed"));
    EXPECT_TRUE(contains(check(physics_scene), "physics: motion found in " + kept_file()));
    EXPECT_TRUE(contains(check(replaced(physics_scene, "[0.7, 0.1, 0.08]", "0.5")), "physics: motion found"));
    EXPECT_TRUE(contains(check(physics_scene, {"-f", "7", "--spp", "1"}), "physics: motion found"));
    EXPECT_TRUE(contains(check(replaced(physics_scene, "mass: 2", "mass: 3")), "physics: computed"));
}

TEST_F(RenderPhysicsCache, IsFoundByAllFramesOfAnEndlessVideo) {
    const std::string endless = replaced(physics_scene, "video_end: 2, ", "");
    EXPECT_TRUE(contains(check(endless, {"-f", "10"}), "physics: computed"));  // until 1.1 s: simulated until 2 s
    EXPECT_TRUE(contains(check(endless, {"-f", "19"}), "physics: motion found"));
    EXPECT_TRUE(contains(check(endless, {"-f", "20"}), "physics: computed"));
}

TEST_F(RenderPhysicsCache, IsRebuiltWhenDamaged) {
    const Image before =
        render_exr(folder, "before", {folder.write("a.yaml", physics_scene), "--bake-cache", cache, "-f", "5"});
    const std::string bytes = read_bytes(kept_file());
    std::string damaged = bytes;
    damaged[damaged.size() / 2] ^= 1;
    folder.write("cache/drt/" + std::filesystem::path(kept_file()).filename().string(), damaged);
    const std::string text = check(physics_scene);
    EXPECT_TRUE(contains(text, "physics: computed"));
    EXPECT_TRUE(contains(text, "it is damaged"));
    EXPECT_EQ(text.find("warning"), std::string::npos);
    EXPECT_EQ(read_bytes(kept_file()), bytes);
}

TEST_F(RenderPhysicsCache, IsNoConditionForRendering) {
    cache = folder.write("file", "not a folder") + "/cache";
    EXPECT_TRUE(contains(check(physics_scene), "note: the motion is not kept in " + cache));
    cache = folder.file("unused");
    EXPECT_TRUE(contains(check(physics_scene, {"--no-bake-cache"}), "physics: computed"));
    EXPECT_FALSE(std::filesystem::exists(cache));
}

TEST_F(RenderPhysicsCache, SaysNothingWithoutBeingAsked) {
    const ProcessResult r = render({folder.write("scene.yaml", physics_scene), "--check", "--bake-cache", cache});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err.find("ok: "), 0u) << r.err;
    EXPECT_EQ(r.err.find('\n'), r.err.size() - 1) << r.err;
}

TEST_F(RenderPhysicsCache, WarnsOfFramesBeyondTheSimulation) {
    const std::string short_one = replaced(physics_scene, "tolerance: 0.01", "tolerance: 0.01, end: 1");
    EXPECT_EQ(check(short_one, {"-f", "8"}).find("warning"), std::string::npos);
    const std::string text = check(short_one, {"--frames", "5-14"});
    EXPECT_TRUE(contains(text, "scene.yaml:4:"));
    EXPECT_TRUE(contains(text,
                         "warning: the simulation ends at t = 1 s, then its bodies stand still; 5 of 10 frames "
                         "show later times, the first is frame 10 with t = 1.1 s"));
}

}  // namespace
}  // namespace drt
