// Every picture with few samples: what is plainly wrong shows at once. The same with many is in full_picture_test.cpp.

#include "pictures/picture_test.h"

namespace drt {
namespace {

class QuickPicture : public ::testing::TestWithParam<PictureCase> {};

TEST_P(QuickPicture, IsTheReferences) {
    constexpr int quicker = 4;
    expect_same_as_reference(GetParam(), {}, GetParam().reference_spp / quicker, 32);
}

INSTANTIATE_TEST_SUITE_P(All, QuickPicture, ::testing::ValuesIn(all_pictures(::testing::TempDir())), test_name);

}  // namespace
}  // namespace drt
