#include "drt/bake/cache.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "bake/bake_scenes.h"
#include "drt/bake/cache_folder.h"
#include "support/process.h"

namespace drt {
namespace {

using namespace test;

// Two keys, so that its file is small.
BakeInput small_input() {
    SceneDesc s = scene_with_camera();
    s.gravity = Vec3d{};
    s.simulation.tolerance = 1e-3;
    s.bodies = {with_physics(sphere({1, 2, 3}, 0.5))};
    s.bodies[0].physics->velocity = {1, 0, 0};
    s.bodies[0].physics->angular_velocity_degrees = {300, 0, 0};  // a turn
    return bake_input(s, 0);
}

TEST(BakeCache, FindsWhatItKept) {
    const TempFolder folder;
    const std::string cache = folder.file("a/b");  // made when needed
    const CachedMotion first = cached_motion(small_input(), cache);
    EXPECT_FALSE(first.found);
    EXPECT_EQ(first.found_not_because, "there is none");
    EXPECT_EQ(first.kept_not_because, "");
    const CachedMotion second = cached_motion(small_input(), cache);
    EXPECT_TRUE(second.found);
    EXPECT_EQ(second.file, first.file);
    EXPECT_EQ(second.motion, first.motion);
    EXPECT_EQ(second.motion, compute_motion(small_input()));
}

TEST(BakeCache, KeepsEveryInputApart) {
    const TempFolder folder;
    const CachedMotion kept = cached_motion(small_input(), folder.file("cache"));
    EXPECT_TRUE(kept.motion.motions.at(0).keys.back().turn);  // so that a turn is read back, too
    BakeInput other = small_input();
    other.scene.bodies[0].physics->velocity = {2, 0, 0};
    const CachedMotion other_kept = cached_motion(other, folder.file("cache"));
    EXPECT_FALSE(other_kept.found);
    EXPECT_NE(other_kept.file, kept.file);
    EXPECT_NE(other_kept.motion, kept.motion);
}

// Whatever happened to the file, the motion is right and the file is whole again.
void expect_rebuilt(const std::string& cache, const CachedMotion& good, const std::string& bytes,
                    const std::string& what) {
    std::filesystem::remove(good.file);
    {
        std::FILE* f = std::fopen(good.file.c_str(), "wb");
        ASSERT_TRUE(f);
        std::fwrite(bytes.data(), 1, bytes.size(), f);
        std::fclose(f);
    }
    const CachedMotion again = cached_motion(small_input(), cache);
    ASSERT_FALSE(again.found) << what;
    ASSERT_NE(again.found_not_because, "") << what;
    ASSERT_EQ(again.motion, good.motion) << what;
}

TEST(BakeCache, NeverTrustsADamagedFile) {
    const TempFolder folder;
    const std::string cache = folder.file("cache");
    const CachedMotion good = cached_motion(small_input(), cache);
    const std::string bytes = read_bytes(good.file);
    ASSERT_GT(bytes.size(), 100u);
    ASSERT_LT(bytes.size(), 1000u);
    for (size_t i = 0; i < bytes.size(); ++i) {
        std::string flipped = bytes;
        flipped[i] = char(flipped[i] ^ (1 << i % 8));
        expect_rebuilt(cache, good, flipped, "bit of byte " + std::to_string(i));
    }
    for (size_t size = 0; size < bytes.size(); size += 7)
        expect_rebuilt(cache, good, bytes.substr(0, size), "cut to " + std::to_string(size));
    expect_rebuilt(cache, good, bytes + "x", "something appended");
    expect_rebuilt(cache, good, "drt: 1\n", "another file");
    EXPECT_EQ(read_bytes(good.file), bytes);
    EXPECT_TRUE(cached_motion(small_input(), cache).found);
}

TEST(BakeCache, DoesNotTakeTheFileOfAnotherScene) {
    const TempFolder folder;
    const std::string cache = folder.file("cache");
    const CachedMotion good = cached_motion(small_input(), cache);
    BakeInput other = small_input();
    other.scene.bodies[0].physics->velocity = {2, 0, 0};
    const CachedMotion other_kept = cached_motion(other, cache);
    expect_rebuilt(cache, good, read_bytes(other_kept.file), "another scene's");
}

// Nor does it wait for a pipe to be written to, or follow a link.
TEST(BakeCache, TouchesOnlyFiles) {
    const TempFolder folder;
    const std::string cache = folder.file("cache"), precious = folder.write("precious", "precious");
    const CachedMotion good = cached_motion(small_input(), cache);
    const auto expect_refused = [&](const std::string& why) {
        const CachedMotion again = cached_motion(small_input(), cache);
        EXPECT_EQ(again.motion, good.motion);
        EXPECT_EQ(again.found_not_because, why);
        EXPECT_EQ(again.kept_not_because, why);
        std::filesystem::remove_all(good.file);
    };
    std::filesystem::remove(good.file);
    ASSERT_EQ(mkfifo(good.file.c_str(), 0600), 0);
    expect_refused("it is not a regular file");
    ASSERT_EQ(mkfifo(folder.file("pipe").c_str(), 0600), 0);
    for (const std::string target : {"pipe", "precious", "absent"}) {
        std::filesystem::create_symlink(folder.file(target), good.file);
        expect_refused("it is not a regular file");
    }
    std::filesystem::create_directories(good.file + "/inside");
    expect_refused("it is a folder");
    EXPECT_EQ(read_bytes(precious), "precious");
    EXPECT_FALSE(std::filesystem::exists(folder.file("absent")));
}

TEST(BakeCache, DoesNotReadEnormousFiles) {
    const TempFolder folder;
    const std::string cache = folder.file("cache");
    const CachedMotion good = cached_motion(small_input(), cache);
    std::filesystem::resize_file(good.file, largest_bake_file + 1);  // of which nothing is on the disk
    const CachedMotion again = cached_motion(small_input(), cache);
    EXPECT_EQ(again.motion, good.motion);
    EXPECT_EQ(again.found_not_because, "it is too large");
    EXPECT_TRUE(cached_motion(small_input(), cache).found);
}

TEST(BakeCache, NotesEveryUse) {
    const TempFolder folder;
    const CachedMotion kept = cached_motion(small_input(), folder.file("cache"));
    const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(1000);
    std::filesystem::last_write_time(kept.file, old);
    EXPECT_TRUE(cached_motion(small_input(), folder.file("cache")).found);
    EXPECT_GT(std::filesystem::last_write_time(kept.file), old + std::chrono::hours(999));
}

TEST(BakeCache, DoesNotGrowForEver) {
    const TempFolder folder;
    const std::string cache = folder.file("cache");
    for (int i = 0; i < 1005; ++i)
        folder.write("cache/" + std::string(28, 'a') + std::to_string(1000 + i) + ".bake",
                     std::string(bake_file_magic));
    const CachedMotion kept = cached_motion(small_input(), cache);
    EXPECT_EQ(kept.kept_not_because, "");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(cache), std::filesystem::directory_iterator()), 1000);
    EXPECT_TRUE(cached_motion(small_input(), cache).found);
}

TEST(BakeCache, IsNotNeeded) {
    const TempFolder folder;
    const BakedMotion motion = compute_motion(small_input());
    const std::string file = folder.write("file", "not a folder");
    const CachedMotion refused = cached_motion(small_input(), file + "/cache");
    EXPECT_EQ(refused.motion, motion);
    EXPECT_NE(refused.kept_not_because, "");
    EXPECT_EQ(cached_motion(small_input(), "").motion, motion);
}

TEST(BakeCache, FolderIsTheUsers) {
    setenv("HOME", "/home/somebody", 1);
    setenv("XDG_CACHE_HOME", "/caches", 1);
    EXPECT_EQ(default_bake_cache(), "/caches/drt");
    setenv("XDG_CACHE_HOME", "relative", 1);  // is to be ignored
    EXPECT_EQ(default_bake_cache(), "/home/somebody/.cache/drt");
    unsetenv("XDG_CACHE_HOME");
    EXPECT_EQ(default_bake_cache(), "/home/somebody/.cache/drt");
    unsetenv("HOME");
    EXPECT_EQ(default_bake_cache(), "");
}

}  // namespace
}  // namespace drt
