// The same bits for any number of threads, any tiles, any passes, any run.

#include <gtest/gtest.h>

#include "pictures/scenes.h"
#include "support/render_picture.h"

namespace drt {
namespace {

using Precision = PlanOptions::Precision;

/// Every effect at once, in float and in double.
class Determinism : public ::testing::TestWithParam<Precision> {
protected:
    RenderPlan plan() const {
        PlanOptions options;
        options.frame = picture_.frame;
        options.precision = GetParam();
        return compile(picture_.scene, options);
    }
    static RenderOptions spp(int n) {
        RenderOptions options;
        options.spp = n;
        return options;
    }
    PictureCase picture_ = find_picture("everything", ::testing::TempDir());
};

TEST_P(Determinism, RepeatedRuns) {
    const RenderPlan first = plan(), second = plan();
    const RenderResult a = render(first, spp(4)), b = render(first, spp(4)), c = render(second, spp(4));
    EXPECT_TRUE(same_bits(a.film, b.film));
    EXPECT_TRUE(same_bits(a.film, c.film));
    EXPECT_EQ(a.counters.scattered_rays, c.counters.scattered_rays);
    EXPECT_EQ(a.counters.shadow_rays, c.counters.shadow_rays);
}

TEST_P(Determinism, Threads) {
    const RenderPlan p = plan();
    RenderOptions options = spp(4);
    options.tile_size = 8;  // tiles for every thread
    options.threads = 1;
    const RenderResult one = render(p, options);
    for (const int threads : {2, 7}) {
        options.threads = threads;
        const RenderResult many = render(p, options);
        EXPECT_EQ(many.threads, threads);
        EXPECT_TRUE(same_bits(one.film, many.film)) << threads << " threads";
        EXPECT_EQ(one.counters.shadow_rays, many.counters.shadow_rays);
    }
}

TEST_P(Determinism, TileSizes) {
    const RenderPlan p = plan();
    RenderOptions options = spp(4);
    const RenderResult usual = render(p, options);
    for (options.tile_size = 4; options.tile_size <= 32; options.tile_size *= 2)
        EXPECT_TRUE(same_bits(usual.film, render(p, options).film)) << "tiles of " << options.tile_size;
    for (const int bad : {0, 2, 12, 64}) {
        options.tile_size = bad;
        EXPECT_THROW(render(p, options), Error) << bad;
    }
}

// After each pass the film is the one of a run that was asked for just as many samples.
TEST_P(Determinism, Passes) {
    const RenderPlan p = plan();
    RenderEvents events;
    std::vector<int> passes;
    events.pass_done = [&](const Film& film, const Progress& progress) {
        passes.push_back(progress.spp_done);
        EXPECT_TRUE(same_bits(film, render(p, spp(progress.spp_done)).film)) << progress.spp_done << " samples";
    };
    EXPECT_EQ(render(p, spp(11), events).spp_done, 11);
    EXPECT_EQ(passes, (std::vector<int>{1, 2, 4, 8, 11}));
}

TEST_P(Determinism, EveryCameraSampleIsTakenOnce) {
    const RenderResult result = render(plan(), spp(5));
    EXPECT_EQ(result.counters.camera_rays, 5u * 48 * 36);
    EXPECT_EQ(result.counters.film.nonfinite.count, 0u);
    EXPECT_EQ(result.counters.trace.rejected, 0u);
    for (int y = 0; y < 36; ++y)
        for (int x = 0; x < 48; ++x) {
            ASSERT_EQ(samples_at(result.film, 0, x, y), 3u);
            ASSERT_EQ(samples_at(result.film, 1, x, y), 2u);
        }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Determinism, ::testing::Values(Precision::single, Precision::double_),
                         [](const auto& test) { return test.param == Precision::single ? "float" : "double"; });

}  // namespace
}  // namespace drt
