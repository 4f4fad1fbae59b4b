#include "drt/film/film.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "drt/film/error_estimate.h"
#include "film/film_kit.h"

namespace drt {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

TEST(Film, HoldsTheMeansOfItsSamples) {
    PixelFilm p;
    p.add(0, {0.5f, 1, -2, 1});
    p.add(1, {1.5f, 2, -4, 0});
    p.add(2, {4, 3, 0, 0.5f});
    EXPECT_EQ(p.mean(), (std::vector<float>{2, 2, -2, 0.5f}));
    EXPECT_EQ(resolve(p.film, 0).data[0], 2.25f);  // samples 0 and 2
    EXPECT_EQ(resolve(p.film, 1).data[0], 1.5f);   // sample 1
    EXPECT_EQ(p.counters.nonfinite.count + p.counters.overflowed.count, 0u);
    EXPECT_EQ(resolve(Film(2, 1)).data, std::vector<float>(8));
}

// Of every magnitude, at the edges of every level, and of either sign.
TEST(Film, HoldsEveryFloatExactly) {
    std::mt19937 random(1);
    std::uniform_int_distribution<std::uint32_t> fraction(0, (1u << 23) - 1);
    for (std::uint32_t exponent = 5; exponent < 255; ++exponent)
        for (const std::uint32_t f : {0u, (1u << 23) - 1, fraction(random), fraction(random)}) {
            const auto value = std::bit_cast<float>(exponent << 23 | f);
            PixelFilm p;
            for (std::uint32_t i = 0; i < 3; ++i) p.add(2 * i, {value, -value, 0, 1});
            ASSERT_EQ(p.mean(), (std::vector<float>{value, -value, 0, 1})) << value;
        }
}

TEST(Film, RoundsTheSmallestFloatsToTheLowestUnit) {
    PixelFilm p;
    p.add(0, {0x1p-126f, 0x1.8p-145f, -0x1p-147f, 0});
    EXPECT_EQ(p.mean()[0], 0x1p-126f);
    EXPECT_EQ(p.mean()[1], 0x1p-144f);
    EXPECT_EQ(p.mean()[2], 0.0f);
}

TEST(Film, LevelsMeet) {
    for (int level = 0; level < level_count; ++level) {
        EXPECT_EQ(level_of(first_bits(level)), level);
        EXPECT_EQ(level_of(first_bits(level + 1) - 1), level);
    }
    EXPECT_EQ(level_of(std::int32_t(1)), 0);
}

// 1e-13 beside 1e12: what is added and taken away again leaves the rest as it was.
TEST(Film, FaintAndBrightAddUpInOnePixel) {
    PixelFilm p;
    p.add(0, {1e12f, 1e-13f, 1e38f, 1});
    p.add(2, {1e-13f, 1e12f, 1e-35f, 1});
    p.add(4, {-1e12f, 1, -1e38f, 1});
    const std::vector<float> mean = p.mean();
    EXPECT_EQ(mean[0], float(double(1e-13f) / 3));
    EXPECT_EQ(mean[1], float((double(1e12f) + 1) / 3));
    EXPECT_EQ(mean[2], float(double(1e-35f) / 3));
}

struct Sample {
    std::uint32_t number;
    std::array<float, 4> rgba;
};

/// Of all magnitudes, some not even finite.
std::vector<Sample> wild_samples(std::uint32_t n, std::mt19937& random) {
    std::uniform_real_distribution<float> sign(-1, 1), exponent(-125, 127);
    std::vector<Sample> samples;
    for (std::uint32_t i = 0; i < n; ++i) {
        const auto value = [&] { return std::exp2(exponent(random)) * sign(random); };
        samples.push_back({i, {value(), i % 100 == 7 ? nan : value(), i % 100 == 9 ? -infinity : value(), 1}});
    }
    return samples;
}

// Integer sums: any order of any samples gives the same bits, and so do parts that are merged. Floats would not.
TEST(Film, SumsDoNotDependOnTheOrderNorOnTheParts) {
    std::mt19937 random(1);
    std::vector<Sample> samples = wild_samples(1000, random);
    const auto film_of = [](auto begin, auto end) {
        PixelFilm p;
        for (auto s = begin; s != end; ++s) p.add(s->number, s->rgba);
        return p.film;
    };
    const Film first = film_of(samples.begin(), samples.end());
    for (int i = 0; i < 5; ++i) {
        std::shuffle(samples.begin(), samples.end(), random);
        const auto cut = samples.begin() + 200 * i;
        Film merged = film_of(cut, samples.end());
        merge(merged, film_of(samples.begin(), cut));
        EXPECT_EQ(merged.blocks, first.blocks);
        EXPECT_EQ(resolve(merged).data, resolve(first).data);
    }
    Film other(2, 1);
    EXPECT_THROW(merge(other, first), std::invalid_argument);
}

TEST(Film, TooBrightSamplesAreCutToTheLargestNumberAndCounted) {
    PixelFilm p;
    p.add(0, {infinity, -infinity, largest, 1});
    EXPECT_EQ(p.mean(), (std::vector<float>{largest, -largest, largest, 1}));
    EXPECT_EQ(p.counters.overflowed.count, 1u);
    p.add(1, {largest, -largest, largest, 1});  // the largest itself is not too large
    EXPECT_EQ(p.mean(), (std::vector<float>{largest, -largest, largest, 1}));
    EXPECT_EQ(p.counters.overflowed.count, 1u);
    EXPECT_EQ(p.counters.nonfinite.count, 0u);
}

// Dropped, but taken: the mean does not rise where some samples fail.
TEST(Film, SamplesThatAreNoNumberCountAsBlack) {
    Film film(8, 8);
    FilmCounters counters;
    const auto add = [&](std::uint32_t sample, const std::array<float, 4>& rgba) {
        BlockValues v{};
        for (size_t c = 0; c < 4; ++c) v[c].fill(0.5f), v[c][9] = rgba[c];  // pixel 1, 2 of the block
        add_block(film, sample, 4, 0, one_sample(v), counters);
    };
    add(4, {2, 2, 2, 1});
    const std::array<std::array<float, 4>, 4> bad{
        {{0, nan, 0, 1}, {infinity, 0, -nan, 1}, {0, 0, 0, nan}, {nan, -infinity, 0, 1}}};
    for (std::uint32_t i = 0; i < bad.size(); ++i) add(5 + i, bad[i]);
    EXPECT_EQ(counters.nonfinite.count, 4u);
    EXPECT_EQ(counters.overflowed.count, 0u);
    EXPECT_EQ(counters.nonfinite.first_sample, 5u);
    EXPECT_EQ(counters.nonfinite.first_x, 5);
    EXPECT_EQ(counters.nonfinite.first_y, 2);
    EXPECT_EQ(samples_at(film, 0, 5, 2) + samples_at(film, 1, 5, 2), 5u);
    EXPECT_EQ(resolve(film).pixel(5, 2)[0], 0.4f);
    EXPECT_EQ(resolve(film).pixel(4, 2)[0], 0.5f);
}

// Which thread met a bad sample, and when, must not show: the first is the one with the lowest sample, row, column.
TEST(Film, MergedCountersDoNotDependOnTheOrder) {
    Film film(8, 8);
    std::array<FilmCounters, 4> parts;
    const auto spoil = [&](std::uint32_t sample, int x, int y, float value, FilmCounters& counters) {
        BlockValues v{};
        for (size_t i = 0; i < block_pixels; ++i)
            if (block_x[i] == x % block_side && block_y[i] == y % block_side) v[0][i] = value;
        add_block(film, sample, x / block_side * block_side, y / block_side * block_side, one_sample(v), counters);
    };
    spoil(3, 5, 1, nan, parts[0]);
    spoil(2, 7, 6, nan, parts[0]);
    spoil(2, 0, 7, nan, parts[1]);
    spoil(2, 6, 6, nan, parts[1]);
    spoil(1, 6, 6, infinity, parts[2]);
    FilmCounters forward, backward;
    for (size_t i = 0; i < parts.size(); ++i) merge(forward, parts[i]), merge(backward, parts[parts.size() - 1 - i]);
    for (const FilmCounters& all : {forward, backward}) {
        EXPECT_EQ(all.nonfinite.count, 4u);
        EXPECT_EQ(all.overflowed.count, 1u);
        EXPECT_EQ(all.overflowed.first_sample, 1u);
        EXPECT_EQ(all.nonfinite.first_sample, 2u);
        EXPECT_EQ(all.nonfinite.first_y, 6);
        EXPECT_EQ(all.nonfinite.first_x, 6);
    }
}

// Several samples at once give what they give one by one, whatever is among them.
TEST(Film, BlocksAreTheirSamples) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-2, 2);
    constexpr size_t stride = block_pixels + 3, count = 4;
    for (const float scale : {0.0f, 1e-30f, 1e-5f, 1.0f, 1e5f, 1e38f})
        for (const float planted : {0.0f, 1e-39f, 1e-20f, -1e-4f, 0.5f, 64.0f, -1e9f, nan, infinity}) {
            std::array<std::array<float, count * stride>, 4> rgba;
            for (auto& channel : rgba)
                for (float& v : channel) v = value(random) * scale;
            rgba[2][3 * stride + 6] = planted;
            const BlockSamples all{{rgba[0].data(), rgba[1].data(), rgba[2].data(), rgba[3].data()}, stride, count};
            Film whole(11, 9), single(11, 9);
            FilmCounters whole_counters, single_counters;
            add_block(whole, 3, 4, 4, all, whole_counters);
            for (std::uint32_t k = 0; k < count; ++k) {
                BlockSamples one = all;
                one.count = 1;
                for (const float*& channel : one.rgba) channel += k * stride;
                add_block(single, 3 + 2 * k, 4, 4, one, single_counters);
            }
            EXPECT_EQ(whole.blocks, single.blocks) << scale << ' ' << planted;
            EXPECT_EQ(whole_counters.overflowed.count, single_counters.overflowed.count);
            EXPECT_EQ(whole_counters.nonfinite.count, single_counters.nonfinite.count);
            EXPECT_EQ(whole_counters.nonfinite.first_sample, single_counters.nonfinite.first_sample);
        }
}

// Blocks hold sums of other levels only where they have met such light; zeros are of none.
TEST(Film, OrdinaryAndBlackBlocksTakeNoMoreMemory) {
    Film film(8, 4);
    FilmCounters counters;
    BlockValues v{};
    add_block(film, 0, 0, 0, one_sample(v), counters);
    v[0] = {0, 0x1p-10f, 63.9f, -1, 0, 0, 0, 0, -0.0f};
    add_block(film, 0, 0, 0, one_sample(v), counters);
    EXPECT_EQ(film.memory(), film_memory(8, 4));
    v[1] = {0, 64};
    v[2] = {0, 0x1p-11f};
    add_block(film, 0, 4, 0, one_sample(v), counters);
    EXPECT_EQ(film.blocks[0][0].far.size(), 0u);
    EXPECT_EQ(film.blocks[0][1].far.size(), 2u);
    EXPECT_GE(film.memory(), film_memory(8, 4) + 2 * sizeof(FarSum));
}

// The most that sums are made for, of the largest number of a level.
TEST(Film, SumsDoNotOverflow) {
    for (const float value : {std::nextafter(64.0f, 0.0f), std::nextafter(0x1p-10f, 0.0f), largest}) {
        PixelFilm p;
        p.add(0, {value, -value, 0, 1});
        for (std::uint64_t n = 1; n < most_summands; n *= 2) merge(p.film, Film(p.film));
        EXPECT_EQ(samples_at(p.film, 0, 0, 0), most_summands);
        EXPECT_EQ(p.mean(), (std::vector<float>{value, -value, 0, 1}));
    }
}

/// Normal noise of a known size in every pixel; `samples` a pixel.
Film noisy_film(int side, std::uint32_t samples, double sigma, std::mt19937& random) {
    Film film(side, side);
    FilmCounters counters;
    std::normal_distribution<float> noise(10, float(sigma));
    for (std::uint32_t s = 0; s < samples; ++s)
        for (int y = 0; y < side; y += block_side)
            for (int x = 0; x < side; x += block_side) {
                BlockValues v{};
                for (auto& channel : v)
                    for (float& f : channel) f = noise(random);
                add_block(film, s, x, y, one_sample(v), counters);
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
