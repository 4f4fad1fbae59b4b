// drt-render and scenes with physics.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>

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
    const std::string without = loaded_libraries({plain, "--explain"});
    EXPECT_EQ(without.find("ullet"), std::string::npos);
    const std::string with = loaded_libraries({physics, "--explain", "--no-bake-cache"});
    EXPECT_TRUE(contains(with, "libdrt-bullet.so"));
    EXPECT_TRUE(contains(with, "libBulletCollision-float64.so"));
}

TEST(RenderPhysics, IsNotComputedByCheck) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", endless_physics_scene());
    const ProcessResult r = render({scene, "--check", "--bake-cache", folder.file("cache")},
                                   {.folder = {}, .stdout_file = {}, .timeout = 20});
    EXPECT_EQ(r.exit_code, 0) << r.err;
    EXPECT_TRUE(contains(r.err, "ok: " + scene + " (bodies: 24, "));
    EXPECT_EQ(files_in(folder), std::vector<std::string>{"scene.yaml"});
    const std::string wrong = folder.write("wrong.yaml", replaced(physics_scene, "mass: 2", "mass: -2"));
    EXPECT_EQ(render({wrong, "--check"}).exit_code, 3);
    // What is explained is the plan of a scene whose bodies move.
    const std::string moving = folder.write("moving.yaml", physics_scene);
    const ProcessResult both = render({moving, "--check", "--explain", "--no-bake-cache"});
    EXPECT_EQ(both.out, render({moving, "--explain", "--no-bake-cache"}).out);
    EXPECT_TRUE(contains(both.out, "3 moving bodies"));
}

TEST(RenderPhysics, IsTheSameOnAnyNumberOfThreads) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", physics_scene);
    const Image one = render_exr(folder, "one", {scene, "-f", "5", "-t", "1", "--no-bake-cache"});
    for (const std::string threads : {"2", "3"})
        EXPECT_EQ(render_exr(folder, "more", {scene, "-f", "5", "-t", threads, "--no-bake-cache"}).data, one.data);
}

// How long chaos can be foretold is for the dynamics to say; the warning names the frames beyond.
TEST(RenderPhysics, WarnsOfFramesThatCannotBeTrusted) {
    const TempFolder folder;
    const std::string scene = folder.write(
        "scene.yaml",
        replaced(replaced(endless_physics_scene(), "end: 1e6", "end: 2"), "drt: 1", "drt: 1\nrender: {fps: 20}"));
    const auto run = [&](const std::string& frames) {
        const ProcessResult r = render({scene, "--explain", "--bake-cache", folder.file("cache"), "--frames", frames});
        EXPECT_EQ(r.exit_code, 0) << r.err;
        return r.err;
    };
    const std::string text = run("0-39"), found_text = run("0-39");
    EXPECT_EQ(text, found_text);  // the cache remembers what was said
    const size_t at = text.find("scene.yaml:4:13: warning: the motion can be trusted until t = ");
    ASSERT_NE(at, std::string::npos) << text;
    double trusted = 0, shown = 0;
    int count = 0, first = 0;
    ASSERT_EQ(std::sscanf(text.c_str() + text.find("until t = ", at),
                          "until t = %lf s, then the last digits of the description decide; %d of 40 frames show later "
                          "times, the first is frame %d with t = %lf s",
                          &trusted, &count, &first, &shown),
              4)
        << text;
    EXPECT_GT(trusted, 0.05);
    EXPECT_LT(trusted, 2);
    EXPECT_EQ(count, 40 - first);
    EXPECT_NEAR(shown, (first + 1) / 20.0, 1e-5);
    EXPECT_GT(shown, trusted);
    EXPECT_LE(first / 20.0, trusted * (1 + 1e-5));
    EXPECT_EQ(run("0-" + std::to_string(first - 1)).find("trusted"), std::string::npos);
}

class RenderPhysicsCache : public testing::Test {
protected:
    // What is said of the cache.
    std::string explain(const std::string& text, const std::vector<std::string>& more = {}) {
        std::vector<std::string> arguments{folder.write("scene.yaml", text), "--explain", "-v", "--bake-cache", cache};
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
    EXPECT_TRUE(contains(explain(physics_scene), "physics: computed"));
    EXPECT_TRUE(contains(explain(physics_scene), "physics: motion found in " + kept_file()));
    EXPECT_TRUE(contains(explain(replaced(physics_scene, "[0.7, 0.1, 0.08]", "0.5")), "physics: motion found"));
    EXPECT_TRUE(contains(explain(physics_scene, {"-f", "7", "--spp", "1"}), "physics: motion found"));
    EXPECT_TRUE(contains(explain(replaced(physics_scene, "mass: 2", "mass: 3")), "physics: computed"));
}

TEST_F(RenderPhysicsCache, IsFoundByAllFramesOfAnEndlessVideo) {
    const std::string endless = replaced(physics_scene, "video_end: 2, ", "");
    EXPECT_TRUE(contains(explain(endless, {"-f", "10"}), "physics: computed"));  // until 1.1 s: simulated until 2 s
    EXPECT_TRUE(contains(explain(endless, {"-f", "19"}), "physics: motion found"));
    EXPECT_TRUE(contains(explain(endless, {"-f", "20"}), "physics: computed"));
}

TEST_F(RenderPhysicsCache, IsRebuiltWhenDamaged) {
    const std::string scene = folder.write("a.yaml", physics_scene);
    const auto picture = [&](const std::string& name) {
        return render_exr(folder, name, {scene, "--bake-cache", cache, "-f", "5"});
    };
    const Image before = picture("before");
    const std::string bytes = read_bytes(kept_file());
    const auto damage = [&] {
        std::string damaged = bytes;
        damaged[damaged.size() / 2] ^= 1;
        folder.write("cache/drt/" + std::filesystem::path(kept_file()).filename().string(), damaged);
    };
    damage();
    EXPECT_EQ(picture("after").data, before.data);
    EXPECT_EQ(read_bytes(kept_file()), bytes);
    EXPECT_EQ(picture("found").data, before.data);
    damage();
    const std::string text = explain(physics_scene);
    EXPECT_TRUE(contains(text, "physics: computed"));
    EXPECT_TRUE(contains(text, "it is damaged"));
    EXPECT_EQ(text.find("warning"), std::string::npos);
    EXPECT_EQ(read_bytes(kept_file()), bytes);
}

TEST_F(RenderPhysicsCache, DoesNotWaitForAPipe) {
    explain(physics_scene);
    const std::string file = kept_file();
    std::filesystem::remove(file);
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    const std::string text = explain(physics_scene);
    EXPECT_TRUE(contains(text, file + ": it is not a regular file)"));
    EXPECT_TRUE(contains(text, "note: the motion is not kept in " + file + ": it is not a regular file"));
}

TEST_F(RenderPhysicsCache, IsNoConditionForRendering) {
    cache = folder.write("file", "not a folder") + "/cache";
    EXPECT_TRUE(contains(explain(physics_scene), "note: the motion is not kept in " + cache));
    cache = folder.file("unused");
    EXPECT_TRUE(contains(explain(physics_scene, {"--no-bake-cache"}), "physics: computed"));
    EXPECT_FALSE(std::filesystem::exists(cache));
}

TEST_F(RenderPhysicsCache, SaysNothingWithoutBeingAsked) {
    const ProcessResult r = render({folder.write("scene.yaml", physics_scene), "--explain", "--bake-cache", cache});
    EXPECT_EQ(r.exit_code, 0);
    EXPECT_EQ(r.err, "");
}

TEST_F(RenderPhysicsCache, WarnsOfFramesBeyondTheSimulation) {
    const std::string short_one = replaced(physics_scene, "tolerance: 0.01", "tolerance: 0.01, end: 1");
    EXPECT_EQ(explain(short_one, {"-f", "8"}).find("warning"), std::string::npos);
    const std::string text = explain(short_one, {"--frames", "5-14"});
    EXPECT_TRUE(contains(text, "scene.yaml:4:"));
    EXPECT_TRUE(contains(text,
                         "warning: the simulation ends at t = 1 s, then its bodies stand still; 5 of 10 frames "
                         "show later times, the first is frame 10 with t = 1.1 s"));
}

}  // namespace
}  // namespace drt
