#include "drt/scene/scene_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "drt/scene/scene_desc.h"
#include "drt/scene/utf8.h"
#include "drt/scene/value_text.h"

namespace drt {
namespace {

TEST(ScenePath, SpellsNamesAndIndices) {
    const ScenePath root;
    EXPECT_EQ(root.str(), "");
    EXPECT_EQ(((root / "cameras")[0] / "motion" / "keys")[12].str(), "cameras[0].motion.keys[12]");
    EXPECT_EQ(((root / "bodies")[3] / "radius").str(), "bodies[3].radius");
}

TEST(SourceMap, FindsTheNearestEnclosingPlace) {
    SourceMap sources;
    sources.places["bodies[1]"] = {"a.yaml", 5, 3};
    EXPECT_EQ(sources.find("bodies[1].motion.keys[2].time"), (Location{"a.yaml", 5, 3}));
    EXPECT_EQ(sources.find("bodies[11].radius"), Location{});
    sources.places[""] = {"a.yaml", 0, 0};
    EXPECT_EQ(sources.find("bodies[11].radius"), (Location{"a.yaml", 0, 0}));
}

TEST(SourceMap, WhatIsPartOfSomethingUnreadIsUnread) {
    SourceMap sources;
    EXPECT_FALSE(sources.is_unread("bodies[3].radius"));
    sources.unread = {"bodies[3]", "cameras[0].up"};
    EXPECT_TRUE(sources.is_unread("bodies[3]"));
    EXPECT_TRUE(sources.is_unread("bodies[3].radius"));
    EXPECT_TRUE(sources.is_unread("cameras[0].up.start"));
    EXPECT_FALSE(sources.is_unread("cameras[0]"));
    EXPECT_FALSE(sources.is_unread("bodies[31].radius"));
}

TEST(ValueText, IsTheShortestThatReadsBack) {
    EXPECT_EQ(to_text(0.1), "0.1");
    EXPECT_EQ(to_text(0.1f), "0.1");
    EXPECT_EQ(to_text(1.0 / 3), "0.3333333333333333");
    EXPECT_EQ(to_text(-1e22), "-1e+22");
    EXPECT_EQ(to_text(std::nan("")), "nan");
    EXPECT_EQ(to_text(std::numeric_limits<std::uint32_t>::max()), "4294967295");
    EXPECT_EQ(to_text(Vec3d{1, -2.5, 0}), "[1, -2.5, 0]");
    EXPECT_EQ(to_text(Color{0.25f}), "0.25");
    EXPECT_EQ(to_text(Color{1, 0, 0.5f}), "[1, 0, 0.5]");
}

TEST(Utf8, AcceptsEveryLengthAndRefusesWhatIsNotWellFormed) {
    const auto npos = std::string_view::npos;
    EXPECT_EQ(find_invalid_utf8("plain"), npos);
    EXPECT_EQ(find_invalid_utf8("m\xc3\xad\xc4\x8d \xe2\x82\xac \xf0\x9f\x98\x80 \xf4\x8f\xbf\xbf"), npos);
    EXPECT_EQ(find_invalid_utf8("ab\xff"), 2u);            // no such byte
    EXPECT_EQ(find_invalid_utf8("ab\xe9t\xe9"), 2u);       // Latin-1
    EXPECT_EQ(find_invalid_utf8("\xc0\xaf"), 0u);          // overlong
    EXPECT_EQ(find_invalid_utf8("\xe0\x80\xaf"), 0u);      // overlong
    EXPECT_EQ(find_invalid_utf8("\xed\xa0\x80"), 0u);      // surrogate
    EXPECT_EQ(find_invalid_utf8("\xf4\x90\x80\x80"), 0u);  // above U+10FFFF
    EXPECT_EQ(find_invalid_utf8("a\xf0\x9f\x98"), 1u);     // cut off
}

}  // namespace
}  // namespace drt
