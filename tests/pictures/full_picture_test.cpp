// Every picture with enough samples to see a light 2 % off or a lobe 5 % wider (sensitivity_test.cpp).

#include "pictures/picture_test.h"

namespace drt {
namespace {

class FullPicture : public ::testing::TestWithParam<PictureCase> {};

TEST_P(FullPicture, IsTheReferences) {
    expect_same_as_reference(GetParam(), {}, GetParam().reference_spp, GetParam().render_spp);
}

INSTANTIATE_TEST_SUITE_P(All, FullPicture, ::testing::ValuesIn(all_pictures(::testing::TempDir())), test_name);

}  // namespace
}  // namespace drt
