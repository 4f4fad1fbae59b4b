#include "pictures/scenes.h"

#include <gtest/gtest.h>

#include <set>

namespace drt {
namespace {

TEST(PictureScenes, AreValidAndTheirNamesUnique) {
    std::set<std::string> names;
    for (const PictureCase& picture : all_pictures(::testing::TempDir())) {
        for (const Diagnostic& d : validate(picture.scene)) ADD_FAILURE() << picture.name << ": " << to_string(d);
        EXPECT_TRUE(names.insert(picture.name).second) << picture.name;
    }
    EXPECT_GE(names.size(), 10u);
}

}  // namespace
}  // namespace drt
