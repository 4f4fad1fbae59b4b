#include "drt/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace drt {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(Film, MeansAreExactToTheFixedPoint) {
    Film film(2, 1);
    FilmCounters counters;
    add_sample(film, 0, 0, 0, {0.5f, 1, -2, 1}, counters);
    add_sample(film, 1, 0, 0, {1.5f, 2, -4, 0}, counters);
    add_sample(film, 2, 0, 0, {4, 3, 0, 0.5f}, counters);
    EXPECT_EQ(resolve(film).data, (std::vector<float>{2, 2, -2, 0.5f, 0, 0, 0, 0}));
    EXPECT_EQ(resolve(film, 0).pixel(0, 0)[0], 2.25f);  // samples 0 and 2
    EXPECT_EQ(resolve(film, 1).pixel(0, 0)[0], 1.5f);   // sample 1
    EXPECT_EQ(counters.nonfinite + counters.clamped, 0u);
}

TEST(Film, OneSampleIsRoundedOnceToTheNearestStep) {
    const float step = float(1 / fixed_point_scale);
    for (const float value : {0.3f, 1.0f / 3, 0.4f * step, 0.6f * step, -0.6f * step, 60000.3f}) {
        Film film(1, 1);
        FilmCounters counters;
        add_sample(film, 0, 0, 0, {value, 0, 0, 0}, counters);
        EXPECT_EQ(resolve(film).data[0], float(std::nearbyint(double(value) * fixed_point_scale) / fixed_point_scale));
    }
}

// Integer sums: any order of any samples gives the same bits. Floats would not.
TEST(Film, SumsDoNotDependOnTheOrder) {
    struct Sample {
        std::uint32_t number;
        std::array<float, 4> rgba;
    };
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-1, 1);
    std::vector<Sample> samples;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const float large = i % 100 == 0 ? 60000.0f : 1e-3f;
        samples.push_back({i, {value(random) * large, value(random), value(random), 1}});
    }
    const auto picture = [&] {
        Film film(1, 1);
        FilmCounters counters;
        for (const Sample& s : samples) add_sample(film, s.number, 0, 0, s.rgba, counters);
        return resolve(film).data;
    };
    const auto first = picture();
    for (int i = 0; i < 5; ++i) {
        std::shuffle(samples.begin(), samples.end(), random);
        EXPECT_EQ(picture(), first);
    }
}

TEST(Film, TooLargeSamplesAreClampedAndCounted) {
    Film film(1, 1);
    FilmCounters counters;
    add_sample(film, 0, 0, 0, {1e6f, -1e30f, sample_limit, 1}, counters);
    EXPECT_EQ(resolve(film).data, (std::vector<float>{sample_limit, -sample_limit, sample_limit, 1}));
    EXPECT_EQ(counters.clamped, 1u);
    add_sample(film, 1, 0, 0, {sample_limit, 0, 0, 1}, counters);  // the limit itself is not too large
    EXPECT_EQ(counters.clamped, 1u);
    // Finite channels whose sum is not: counted as too large, not as dropped.
    add_sample(film, 2, 0, 0, {3e38f, 3e38f, 0, 1}, counters);
    EXPECT_EQ(counters.clamped, 2u);
    EXPECT_EQ(counters.nonfinite, 0u);
}

TEST(Film, NonfiniteSamplesAreDroppedAndTheFirstIsRemembered) {
    Film film(8, 8);
    FilmCounters counters;
    add_sample(film, 4, 1, 2, {1, 1, 1, 1}, counters);
    const std::array<std::array<float, 4>, 5> bad{
        {{0, nan, 0, 1}, {infinity, 0, 0, 1}, {0, 0, -infinity, 1}, {infinity, -infinity, 0, 1}, {0, 0, 0, nan}}};
    for (std::uint32_t i = 0; i < bad.size(); ++i) add_sample(film, 5 + i, 1, 2, bad[i], counters);
    EXPECT_EQ(counters.nonfinite, 5u);
    EXPECT_EQ(counters.clamped, 0u);
    EXPECT_EQ(counters.first_nonfinite_sample, 5u);
    EXPECT_EQ(counters.first_nonfinite_x, 1);
    EXPECT_EQ(counters.first_nonfinite_y, 2);
    EXPECT_EQ(resolve(film).pixel(1, 2)[0], 1);  // the mean of those that count
}

// Which thread met a bad sample, and when, must not show: the first is the one with the lowest sample, row, column.
TEST(Film, MergedCountersDoNotDependOnTheOrder) {
    Film film(8, 8);
    FilmCounters a, b, c;
    add_sample(film, 3, 5, 1, {nan, 0, 0, 0}, a);
    add_sample(film, 2, 7, 6, {nan, 0, 0, 0}, a);
    add_sample(film, 2, 0, 7, {nan, 0, 0, 0}, b);
    add_sample(film, 2, 6, 6, {nan, 0, 0, 0}, b);
    add_sample(film, 2, 6, 6, {1e6f, 0, 0, 0}, c);
    FilmCounters forward, backward;
    for (const FilmCounters& from : {a, b, c}) merge(forward, from);
    for (const FilmCounters& from : {c, b, a}) merge(backward, from);
    for (const FilmCounters& all : {forward, backward}) {
        EXPECT_EQ(all.nonfinite, 4u);
        EXPECT_EQ(all.clamped, 1u);
        EXPECT_EQ(all.first_nonfinite_sample, 2u);
        EXPECT_EQ(all.first_nonfinite_y, 6);
        EXPECT_EQ(all.first_nonfinite_x, 6);
    }
}

// A block gives what its pixels give one by one, whatever is wrong with them.
TEST(Film, BlocksAreTheirPixels) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-2, 2);
    struct Planted {
        float value;
        unsigned valid;
        int count;  // samples of each pixel
    };
    constexpr size_t stride = block_pixels + 3;
    for (const Planted& planted :
         {Planted{0, 0xffff, 1}, Planted{0, 0xffff, 3}, Planted{0, 0x0137, 2}, Planted{1e9f, 0xffff, 2},
          Planted{nan, 0xffff, 2}, Planted{-infinity, 0xffff, 1}, Planted{sample_limit, 0xffff, 4}}) {
        std::array<std::array<float, 4 * stride>, 4> rgba;
        for (auto& channel : rgba)
            for (float& v : channel) v = value(random);
        const size_t last = size_t(planted.count - 1) * stride;
        if (planted.value != 0) rgba[2][last + 6] = planted.value;
        const BlockSamples block{
            {rgba[0].data(), rgba[1].data(), rgba[2].data(), rgba[3].data()}, stride, planted.count, planted.valid};
        Film whole(11, 9), single(11, 9);
        FilmCounters whole_counters, single_counters;
        add_block(whole, 3, 4, 4, block, whole_counters);
        for (size_t k = 0; k < size_t(planted.count); ++k)
            for (size_t i = 0; i < size_t(block_pixels); ++i) {  // in Morton order
                const int x = 4 + int((i & 1) | (i >> 1 & 2)), y = 4 + int((i >> 1 & 1) | (i >> 2 & 2));
                const size_t at = k * stride + i;
                if (planted.valid >> i & 1)
                    add_sample(single, std::uint32_t(3 + 2 * k), x, y,
                               {rgba[0][at], rgba[1][at], rgba[2][at], rgba[3][at]}, single_counters);
            }
        EXPECT_EQ(resolve(whole).data, resolve(single).data) << planted.value;
        EXPECT_EQ(whole.blocks, single.blocks) << planted.value;
        EXPECT_EQ(whole_counters.clamped, single_counters.clamped);
        EXPECT_EQ(whole_counters.nonfinite, single_counters.nonfinite);
        EXPECT_EQ(whole_counters.first_nonfinite_x, single_counters.first_nonfinite_x);
        EXPECT_EQ(whole_counters.first_nonfinite_sample, single_counters.first_nonfinite_sample);
    }
}

// 2^23 samples at the limit would overflow 63 bits; the sums of any picture one can wait for do not.
TEST(Film, HoldsAMillionSamplesAtTheLimit) {
    Film film(1, 1);
    FilmCounters counters;
    for (std::uint32_t i = 0; i < 1000000; ++i)
        add_sample(film, i, 0, 0, {sample_limit, -sample_limit, 0, 1}, counters);
    EXPECT_EQ(resolve(film).data, (std::vector<float>{sample_limit, -sample_limit, 0, 1}));
}

/// Normal noise of a known size in every pixel; `samples` a pixel.
Film noisy_film(int side, std::uint32_t samples, double sigma, std::mt19937& random) {
    Film film(side, side);
    FilmCounters counters;
    std::normal_distribution<float> noise(10, float(sigma));
    for (std::uint32_t s = 0; s < samples; ++s)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const std::array<float, 4> rgba{noise(random), noise(random), noise(random), 1};
                add_sample(film, s, x, y, rgba, counters);
            }
    return film;
}

// 3e4 independent values of one degree of freedom: a standard error of 0.4 %, so 2 % are five of them. Odd numbers of
// samples give replicates of unequal weight.
TEST(Film, EstimatedErrorIsTheTrueOne) {
    std::mt19937 random(1);
    for (const std::uint32_t samples : {2u, 3u, 7u, 16u}) {
        const ErrorEstimate e = estimate_error(noisy_film(100, samples, 0.5, random));
        ASSERT_TRUE(e.valid);
        EXPECT_NEAR(e.rmse / (0.5 / std::sqrt(samples)), 1, 0.02) << samples;
        EXPECT_NEAR(e.relative / e.rmse, 0.1, 1e-3) << samples;
    }
}

TEST(Film, AnErrorNeedsBothReplicatesEverywhere) {
    std::mt19937 random(1);
    EXPECT_FALSE(estimate_error(noisy_film(4, 1, 0.5, random)).valid);
    EXPECT_FALSE(estimate_error(Film(4, 4)).valid);
    EXPECT_TRUE(estimate_error(noisy_film(4, 2, 0.5, random)).valid);
}

}  // namespace
}  // namespace drt
