// When the estimate calls itself a lower bound. Over real scenes: tests/regression/error_study_test.cpp.

#include "drt/film/error_estimate.h"

#include <gtest/gtest.h>

#include <random>

#include "film/film_kit.h"

namespace drt {
namespace {

/// 40 x 40 pixels of `unit`; every `spacing`-th block has one pixel `bright` times as bright in the first replicate.
Film flat_film(int spacing, float bright, float noise = 0, float unit = 1) {
    Film film(40, 40);
    FilmCounters counters;
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    for (std::uint32_t sample = 0; sample < 2; ++sample)
        for (int block = 0; block < 100; ++block) {
            BlockValues v{};
            for (auto& channel : v)
                for (float& f : channel) f = unit * (1 + noise * normal(random));
            if (sample == 0 && spacing > 0 && block % spacing == 0)
                for (auto& channel : v) channel[5] = bright * unit;
            add_block(film, sample, block % 10 * block_side, block / 10 * block_side, one_sample(v), counters);
        }
    return film;
}

TEST(ErrorEstimate, IsALowerBoundWhereFewPixelsCarryIt) {
    EXPECT_TRUE(estimate_error(flat_film(50, 1000)).at_least);  // 2 pixels
    EXPECT_FALSE(estimate_error(flat_film(5, 1000)).at_least);  // 20
    EXPECT_FALSE(estimate_error(flat_film(0, 0, 0.1f)).at_least);
    EXPECT_TRUE(estimate_error(flat_film(50, 1000, 0.1f)).at_least);  // the noise of the others does not hide them
}

// Noise of 0.1 over 1600 pixels of 2 samples: squares of 8 in all. A sample of brightness b would add b^2 / 4.
TEST(ErrorEstimate, IsALowerBoundWhereOneMoreSampleWouldRaiseIt) {
    const Film film = flat_film(0, 0, 0.1f);
    EXPECT_FALSE(estimate_error(film, {1, true}).at_least);
    EXPECT_FALSE(estimate_error(film, {2, true}).at_least);
    EXPECT_TRUE(estimate_error(film, {4, true}).at_least);
    EXPECT_TRUE(estimate_error(film, {1e30, true}).at_least);
}

TEST(ErrorEstimate, OfNothingIsZeroOnlyIfNothingIsRandom) {
    const Film film = flat_film(0, 0);
    EXPECT_EQ(estimate_error(film).rmse, 0);
    EXPECT_TRUE(estimate_error(film, {0, true}).at_least);
    EXPECT_FALSE(estimate_error(film, {0, false}).at_least);
}

// Faint pictures are judged as bright ones are.
TEST(ErrorEstimate, ScalesWithThePicture) {
    const ErrorEstimate one = estimate_error(flat_film(5, 1000));
    for (const float unit : {1e-12f, 1e12f}) {
        const ErrorEstimate scaled = estimate_error(flat_film(5, 1000, 0, unit));
        EXPECT_NEAR(scaled.relative / one.relative, 1, 1e-6);
        EXPECT_NEAR(scaled.rmse / (one.rmse * double(unit)), 1, 1e-6);
    }
}

}  // namespace
}  // namespace drt
