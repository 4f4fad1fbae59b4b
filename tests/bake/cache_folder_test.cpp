// What is deleted of a folder that the cache shares with others, and what is not.

#include "drt/bake/cache_folder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/process.h"

namespace drt {
namespace {

namespace fs = std::filesystem;
using test::TempFolder;

std::string key(int i) {
    std::string digits = std::to_string(i);
    return std::string(32 - digits.size(), 'a') + digits;
}

class CacheFolder : public testing::Test {
protected:
    // Last used so many hours ago.
    std::string add(const std::string& name, const std::string& bytes, int hours) const {
        const std::string path = folder.write(name, bytes);
        fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(hours));
        return path;
    }
    std::string add_kept(int i, int hours, size_t size = 100) const {
        std::string bytes(bake_file_magic);
        bytes.resize(size, 'x');
        return add(key(i) + ".bake", bytes, hours);
    }
    void prune(const CacheLimits& limits) const { prune_cache(folder.path().string(), limits); }

    TempFolder folder;
};

TEST_F(CacheFolder, NamesFilesByTheirKeys) { EXPECT_EQ(bake_file_path("/a/b", key(7)), "/a/b/" + key(7) + ".bake"); }

TEST_F(CacheFolder, LosesWhatWasNotUsedForLongest) {
    std::vector<std::string> files;
    for (const int hours : {5, 1, 9, 3, 7}) files.push_back(add_kept(int(files.size()), hours));
    prune({.files = 5, .bytes = 500});
    for (const std::string& file : files) EXPECT_TRUE(fs::exists(file));
    prune({.files = 3});
    for (const size_t i : {0, 1, 3}) EXPECT_TRUE(fs::exists(files[i])) << i;
    for (const size_t i : {2, 4}) EXPECT_FALSE(fs::exists(files[i])) << i;
    note_use(files[0]);
    prune({.files = 3, .bytes = 299});
    EXPECT_TRUE(fs::exists(files[0]));
    EXPECT_TRUE(fs::exists(files[1]));
    EXPECT_FALSE(fs::exists(files[3]));
    prune({.files = 0, .bytes = 0});
    EXPECT_TRUE(fs::exists(files[0]));
    EXPECT_FALSE(fs::exists(files[1]));
}

TEST_F(CacheFolder, LosesNothingThatIsNotTheCaches) {
    const std::string magic(bake_file_magic), outside = folder.write("outside/" + key(1) + ".bake", magic);
    std::vector<std::string> others{add("scene.yaml", magic, 50),
                                    add("notes.bake", magic, 50),
                                    add(key(1) + "a.bake", magic, 50),               // too many digits
                                    add(key(1).substr(1) + ".bake", magic, 50),      // too few
                                    add(std::string(32, 'A') + ".bake", magic, 50),  // not ours
                                    add(key(1) + ".bake.old", magic, 50),
                                    add(key(1) + ".exr", magic, 50),
                                    add(key(2) + ".bake", "somebody's, by chance", 50),  // its bytes are not
                                    add(key(3) + ".bake", "", 50),
                                    add(key(4) + ".bake.tmp.place.1.0", "", 1),  // perhaps still being written
                                    add(key(5) + ".bake/inside", magic, 50),
                                    outside};
    fs::create_symlink(outside, folder.path() / (key(6) + ".bake"));
    others.push_back(folder.file(key(6) + ".bake"));
    const std::string newest = add_kept(10, 0), kept = add_kept(11, 49),
                      left = add(key(7) + ".bake.tmp.place.1.0", "", 25);
    prune({.files = 1, .bytes = 0});
    for (const std::string& file : others) EXPECT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(fs::exists(newest));
    EXPECT_FALSE(fs::exists(kept));
    EXPECT_FALSE(fs::exists(left));
}

TEST_F(CacheFolder, MayBeMissing) {
    prune_cache(folder.file("absent"));
    prune_cache(folder.write("file", ""));
    EXPECT_TRUE(fs::exists(folder.file("file")));
}

// Processes do no more to each other than threads do here.
TEST_F(CacheFolder, MayBePrunedByManyAtOnce) {
    const std::string newest = add_kept(0, -1);
    std::atomic<bool> done{false};
    std::vector<std::thread> others;
    for (int t = 0; t < 3; ++t)
        others.emplace_back([&] {
            while (!done) prune({.files = 2});
        });
    for (int i = 1; i <= 300; ++i) add_kept(i, 2);
    done = true;
    for (std::thread& t : others) t.join();
    prune({.files = 2});
    EXPECT_TRUE(fs::exists(newest));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 2);
}

}  // namespace
}  // namespace drt
