// What the plan leaves out of a scene does not change its picture.
//
// With everything left in, a standing camera's view is computed for every ray instead of once, and a pinhole is a lens
// of radius 0: both differ in the last bit. In double such a bit never shows, so there the pictures agree to float's
// rounding; in float it turns a few samples at edges, and where the scene has lens and moving camera, nothing at all.
// (Measured with AVX-512, 4 samples a pixel: in double all 43 films are equal bit for bit; in float 10 are, and of the
// others at most 0.05 % of the values differ by more than 1e-4.)

#include "pictures/picture_test.h"
#include "support/render_picture.h"

namespace drt {
namespace {

class GeneralPlan : public ::testing::TestWithParam<PictureCase> {
protected:
    struct Pair {
        Features features;  ///< of the pruned plan
        Film pruned, general;
    };
    static Pair render_both(PlanOptions::Precision precision) {
        PlanOptions options;
        options.frame = GetParam().frame;
        options.precision = precision;
        RenderOptions spp;
        spp.spp = 4;
        const RenderPlan pruned = compile(GetParam().scene, options);
        options.general = true;
        return {pruned.features, render(pruned, spp).film, render_scene(GetParam().scene, options, spp).film};
    }
};

TEST_P(GeneralPlan, IsThePrunedOneInDouble) {
    const Pair pair = render_both(PlanOptions::Precision::double_);
    EXPECT_LT(largest_difference(resolve(pair.pruned), resolve(pair.general)), 1e-5);
}

TEST_P(GeneralPlan, IsThePrunedOneInFloat) {
    const Pair pair = render_both(PlanOptions::Precision::single);
    if (pair.features.lens && pair.features.moving_camera) {
        EXPECT_TRUE(same_bits(pair.pruned, pair.general));
        return;
    }
    const Image a = resolve(pair.pruned), b = resolve(pair.general);
    int different = 0;
    for (size_t i = 0; i < a.data.size(); ++i) different += !(std::abs(a.data[i] - b.data[i]) <= 1e-4f);
    EXPECT_LE(different, int(a.data.size()) / 500);
}

INSTANTIATE_TEST_SUITE_P(All, GeneralPlan, ::testing::ValuesIn(all_pictures(::testing::TempDir())), test_name);

}  // namespace
}  // namespace drt
