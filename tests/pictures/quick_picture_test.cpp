// Every picture with few samples: what is plainly wrong shows at once. The same with many is in full_picture_test.cpp.

#include "pictures/picture_test.h"

namespace drt {
namespace {

constexpr int quicker = 4;

class QuickPicture : public ::testing::TestWithParam<PictureCase> {};

TEST_P(QuickPicture, IsTheReferences) {
    expect_same_as_reference(GetParam(), {}, GetParam().reference_spp / quicker, 32);
}

// The same code in other lanes: pictures that use all of it.
TEST(QuickPictureInDouble, IsTheReferences) {
    PlanOptions options;
    options.precision = PlanOptions::Precision::double_;
    for (const char* name : {"shapes", "nested glass", "glossy reflection", "visible lights", "many visible lights",
                             "textures on round shapes", "camera flight", "moving textures", "everything"}) {
        const PictureCase picture = find_picture(name, ::testing::TempDir());
        expect_same_as_reference(picture, options, picture.reference_spp / quicker, 32);
    }
}

INSTANTIATE_TEST_SUITE_P(All, QuickPicture, ::testing::ValuesIn(all_pictures(::testing::TempDir())), test_name);

}  // namespace
}  // namespace drt
