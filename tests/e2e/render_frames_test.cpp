// Frame lists and frame numbers in file names.
#include <gtest/gtest.h>

#include "apps/drt_render/frames.h"
#include "drt/base/diagnostic.h"

namespace drt {
namespace {

using Frames = std::vector<int>;

TEST(ParseFrames, ListsRangesAndSteps) {
    EXPECT_EQ(parse_frames("7"), Frames{7});
    EXPECT_EQ(parse_frames("0-3"), (Frames{0, 1, 2, 3}));
    EXPECT_EQ(parse_frames("1-10:4"), (Frames{1, 5, 9}));
    EXPECT_EQ(parse_frames("9,1-3,20-30:5"), (Frames{9, 1, 2, 3, 20, 25, 30}));
    EXPECT_EQ(parse_frames("5-5"), Frames{5});
    EXPECT_EQ(parse_frames("2147483647"), Frames{2147483647});
    EXPECT_EQ(parse_frames("2147483645-2147483647:2"), (Frames{2147483645, 2147483647}));
    EXPECT_EQ(parse_frames("0-2147483647:2147483647"), (Frames{0, 2147483647}));
}

TEST(ParseFrames, RendersNoFrameTwice) { EXPECT_EQ(parse_frames("3,1-4,3,0-4:2"), (Frames{3, 1, 2, 4, 0})); }

TEST(ParseFrames, RefusesEverythingElse) {
    for (const char* bad : {"",
                            ",",
                            "1,",
                            ",1",
                            "1,,2",
                            "-1",
                            "1-",
                            "-",
                            "3-1",
                            "1-3:0",
                            "1-3:",
                            "1-3:-1",
                            "1:2",
                            "1-2-3",
                            "a",
                            "1 ",
                            " 1",
                            "1-3 ",
                            "1.5",
                            "+1",
                            "0x1",
                            "2147483648",
                            "99999999999999999999",
                            "1-3:1:1",
                            "1-3x"})
        EXPECT_THROW(parse_frames(bad), Error) << '"' << bad << '"';
}

TEST(ParseFrames, HasALimit) {
    EXPECT_EQ(parse_frames("0-999999").size(), 1000000u);
    EXPECT_THROW(parse_frames("0-1000000"), Error);
    EXPECT_THROW(parse_frames("0-2147483647"), Error);
    EXPECT_THROW(parse_frames("0-600000,700000-1300000"), Error);
    EXPECT_THROW(parse_frames(std::string(1000000, '1')), Error);
}

TEST(ParseFrame, IsOneNumber) {
    EXPECT_EQ(parse_frame("45"), 45);
    for (const char* bad : {"", "1-2", "1,2", "-1", "1x", "x"}) EXPECT_THROW(parse_frame(bad), Error) << bad;
}

TEST(FramePath, ReplacesEveryToken) {
    EXPECT_EQ(frame_path("a.####.exr", 7, false), "a.0007.exr");
    EXPECT_EQ(frame_path("a.####.exr", 7, true), "a.0007.exr");
    EXPECT_EQ(frame_path("a#.exr", 123, true), "a123.exr");
    EXPECT_EQ(frame_path("a.%04d.exr", 7, true), "a.0007.exr");
    EXPECT_EQ(frame_path("a.%4d.exr", 7, true), "a.0007.exr");
    EXPECT_EQ(frame_path("a.%d.exr", 7, true), "a.7.exr");
    EXPECT_EQ(frame_path("shot.##/a.%03d.exr", 7, true), "shot.07/a.007.exr");
}

TEST(FramePath, NumbersSeveralFramesWithoutAToken) {
    EXPECT_EQ(frame_path("out/a.b.exr", 7, true), "out/a.b.0007.exr");
    EXPECT_EQ(frame_path("a.exr", 12345, true), "a.12345.exr");
    EXPECT_EQ(frame_path("out/a.b.exr", 7, false), "out/a.b.exr");
}

TEST(FramePath, LeavesOtherPercentSignsAlone) {
    EXPECT_EQ(frame_path("100%.exr", 7, false), "100%.exr");
    EXPECT_EQ(frame_path("%s%%.%04x.exr", 7, false), "%s%%.%04x.exr");
    EXPECT_EQ(frame_path("%", 7, false), "%");
    EXPECT_EQ(frame_path("%99999999999d.exr", 7, false), "%99999999999d.exr");
    EXPECT_EQ(frame_path("%999d.exr", 7, false), "00000000000000000007.exr");
}

}  // namespace
}  // namespace drt
