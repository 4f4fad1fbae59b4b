// The error that a film states of itself against the true one.

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/scenes.h"
#include "support/render_picture.h"

namespace drt {
namespace {

RenderResult render_seed(const PictureCase& picture, std::uint32_t seed, int spp) {
    SceneDesc scene = picture.scene;
    scene.render.seed = seed;
    PlanOptions plan;
    plan.frame = picture.frame;
    RenderOptions options;
    options.spp = spp;
    return render_scene(scene, plan, options);
}

double squared_error(const Image& picture, const Image& truth) {
    double sum = 0;
    for (size_t i = 0; i < picture.data.size(); ++i)
        if (i % 4 != 3) sum += std::pow(double(picture.data[i]) - double(truth.data[i]), 2);
    return sum / (0.75 * double(picture.data.size()));
}

class ErrorEstimates : public ::testing::TestWithParam<const char*> {};

// Pooled over seeds, so that the ratio's own noise is small.
TEST_P(ErrorEstimates, AreSharp) {
    const PictureCase picture = find_picture(GetParam(), ::testing::TempDir());
    const Image truth = resolve(render_seed(picture, 1000, 8192).film);
    for (const int spp : {4, 16, 64}) {
        double estimated = 0, actual = 0;
        constexpr std::uint32_t seeds = 12;
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            const RenderResult result = render_seed(picture, seed, spp);
            ASSERT_TRUE(result.error.valid);
            estimated += result.error.rmse * result.error.rmse / seeds;
            actual += squared_error(resolve(result.film), truth) / seeds;
        }
        const double ratio = std::sqrt(estimated / actual);
        std::printf("%s, %d samples: RMSE %.5f, estimated / true %.3f\n", GetParam(), spp, std::sqrt(actual), ratio);
        EXPECT_NEAR(ratio, 1, 0.05) << spp << " samples";
    }
}

INSTANTIATE_TEST_SUITE_P(Pictures, ErrorEstimates,
                         ::testing::Values("rectangle light", "glossy reflection", "motion blur"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), ' ', '_');
                             return name;
                         });

}  // namespace
}  // namespace drt
