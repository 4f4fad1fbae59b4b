#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "drt/formats/formats.h"
#include "drt/scene/value_text.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

std::string errors_of(const std::string& text, ErrorKind kind = ErrorKind::scene) {
    const TemporaryFiles files;
    try {
        read_sphere_set(files.write("balls.txt", text));
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), kind);
        return files.without_folder(e.what());
    }
    return {};
}

TEST(SphereSet, ReadsNumbersCommentsAndLineEnds) {
    const TemporaryFiles files;
    const auto spheres = read_sphere_set(files.write("balls.txt",
                                                     "# x y z r\n"
                                                     "\n"
                                                     "1 2 3 0.5\n"
                                                     "\t-1.5e2 +.25 5. 1e-3 # a small one\r\n"
                                                     "  0 0 0 1#last"));
    ASSERT_EQ(spheres.size(), 3u);
    EXPECT_EQ(spheres[0].center, (Vec3d{1, 2, 3}));
    EXPECT_EQ(spheres[0].radius, 0.5);
    EXPECT_EQ(spheres[1].center, (Vec3d{-150, 0.25, 5}));
    EXPECT_EQ(spheres[1].radius, 0.001);
    EXPECT_EQ(spheres[2].radius, 1);
    EXPECT_TRUE(read_sphere_set(files.write("empty.txt", "")).empty());
}

TEST(SphereSet, ReportsEveryBadLineAtItsPlace) {
    EXPECT_EQ(errors_of("1 2 3\n"
                        "1 2 3 0\n"
                        "1 2 3 -4\n"
                        "1 2 3 4 5\n"
                        "1 x 3 4\n"
                        "1 2,5 3 4\n"
                        "nan 0 0 1\n"
                        "0 inf 0 1\n"
                        "0 0 1e400 1\n"
                        "  0 0 2e15 1\n"
                        "0 0 0 1\n"
                        "0 0 0 0x1\n"
                        "- 0 0 1\n"
                        "1 # 2 3 4\n"),
              "balls.txt:1:6: error: too few numbers; expected four numbers: x y z radius\n"
              "balls.txt:2:7: error: radius is out of range \"0\"; expected a number > 0\n"
              "balls.txt:3:7: error: radius is out of range \"-4\"; expected a number > 0\n"
              "balls.txt:4:9: error: too many values \"5\"; expected four numbers: x y z radius\n"
              "balls.txt:5:3: error: not a number \"x\"; expected four numbers: x y z radius\n"
              "balls.txt:6:3: error: not a number \"2,5\"; expected four numbers: x y z radius\n"
              "balls.txt:7:1: error: not a number \"nan\"; expected four numbers: x y z radius\n"
              "balls.txt:8:3: error: not a number \"inf\"; expected four numbers: x y z radius\n"
              "balls.txt:9:5: error: number is too large \"1e400\"; expected at most 1e15 in size\n"
              "balls.txt:10:7: error: number is too large \"2e15\"; expected at most 1e15 in size\n"
              "balls.txt:12:7: error: not a number \"0x1\"; expected four numbers: x y z radius\n"
              "balls.txt:13:1: error: not a number \"-\"; expected four numbers: x y z radius\n"
              "balls.txt:14:3: error: too few numbers; expected four numbers: x y z radius");
}

TEST(SphereSet, StopsAfterTwentyErrors) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "bad\n";
    const std::string errors = errors_of(text);
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 19);
}

TEST(SphereSet, SurvivesBinaryRubbish) {
    std::mt19937 random(1);
    std::string text;
    for (int i = 0; i < 100000; ++i) text += char(random());
    EXPECT_FALSE(errors_of(text).empty());
}

TEST(SphereSet, MissingFilesAreAssets) {
    EXPECT_THROW(
        {
            try {
                read_sphere_set("/nowhere/balls.txt");
            } catch (const Error& e) {
                EXPECT_EQ(e.kind(), ErrorKind::asset);
                EXPECT_STREQ(e.what(), "/nowhere/balls.txt: error: cannot read the file (No such file or directory)");
                throw;
            }
        },
        Error);
}

TEST(SphereSet, ReadsAMillionBallsInASecond) {
    std::mt19937 random(2);
    const auto number = [&] { return to_text(double(random()) / 1048576); };
    std::string text;
    for (int i = 0; i < 250000; ++i) text += number() + ' ' + number() + ' ' + number() + " 0.25\n";
    const TemporaryFiles files;
    const std::string path = files.write("balls.txt", text);
    const std::clock_t start = std::clock();
    EXPECT_EQ(read_sphere_set(path).size(), 250000u);
    // of processor time, with room for a busy machine and for sanitizers
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 2.0);
}

}  // namespace
}  // namespace drt
