// Few samples are as right in the mean as many: the mean over 1000 seeds of pictures of 1, 2 and a prime number of
// samples, in a picture that is not square, against one of very many samples.

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/scene_kit.h"
#include "sampling/statistics.h"
#include "support/render_picture.h"

namespace drt {
namespace {

constexpr int width = 7, height = 5, seeds = 1000;

/// Soft shadows, a lens, glossy reflection and refraction; a filter with negative lobes.
RenderPlan plan_for(std::uint32_t seed) {
    SceneDesc scene = simple_scene({0, 2, 6}, {0, 0.5, 0});
    scene.render.width = width;
    scene.render.height = height;
    scene.render.seed = seed;
    scene.render.filter.kind = Filter::Kind::mitchell;
    scene.render.filter.radius = 2;
    scene.cameras[0].lens.aperture_radius = 0.1;
    add(scene, "floor", Plane{}, shiny({0.7f, 0.7f, 0.7f}, 0.3f, 20));
    add(scene, "ball", sphere({-0.8, 0.8, 0}, 0.7), mirror(0.7, 5));
    add(scene, "lens", sphere({0.8, 0.8, 0}, 0.7), glass(1.5, 0.9, 2));
    scene.lights = {light("lamp", lamp({0, 3, 0}, 1), Color(0.8f), Light::Falloff::none)};
    return compile(scene, {});
}

Image picture(std::uint32_t seed, int spp) {
    RenderOptions options;
    options.spp = spp;
    options.threads = 1;
    return resolve(render(plan_for(seed), options).film);
}

TEST(Unbiased, FewSamplesOverManySeeds) {
    const Image truth = picture(0, 1 << 17);
    const std::vector<int> counts{1, 2, 7};
    // All channels of all pixels at all counts: a false alarm in 100 runs.
    const double level = test::sidak(0.01, int(counts.size()) * width * height * 4);
    for (const int spp : counts) {
        std::vector<double> sum(truth.data.size()), squares(truth.data.size());
        for (std::uint32_t seed = 1; seed <= seeds; ++seed) {
            const Image one = picture(seed, spp);
            for (size_t i = 0; i < sum.size(); ++i) {
                const double difference = double(one.data[i]) - double(truth.data[i]);
                sum[i] += difference;
                squares[i] += difference * difference;
            }
        }
        for (size_t i = 0; i < sum.size(); ++i) {
            const double mean = sum[i] / seeds, variance = (squares[i] - sum[i] * mean) / (seeds - 1);
            ASSERT_TRUE(std::isfinite(mean));
            // Student's t with 999 degrees of freedom is normal to the precision of the level. The truth's own error
            // is a hundredth of the mean's and less.
            const double t = std::abs(mean) / (std::sqrt(variance / seeds) + 1e-6);
            EXPECT_GT(2 * test::normal_tail(t), level)
                << spp << " spp, channel " << i % 4 << " of pixel " << i / 4 << ": off by " << mean;
        }
    }
}

}  // namespace
}  // namespace drt
