#include "drt/sampling/distribution.h"

#include <gtest/gtest.h>

#include <random>

#include "drt/base/diagnostic.h"

namespace drt {
namespace {

/// The slow truth: a linear search.
int search(const Distribution& d, float u) {
    int i = 0;
    while (d.cdf[size_t(i) + 1] <= u) ++i;
    return i;
}

std::vector<std::vector<double>> cases() {
    std::mt19937 rng(3);
    std::uniform_real_distribution<double> unit;
    std::vector<std::vector<double>> all{{1}, {0, 1}, {1, 0}, {1, 1, 1}, {0, 0, 5, 0, 1e-30, 0}, {1e300, 1e-300}};
    std::vector<double> many(1000), skew(777);
    for (double& w : many) w = unit(rng);
    for (double& w : skew) w = std::exp(40 * unit(rng) - 20);
    std::vector<double> one_bright(5000, 1e-9);
    one_bright[4000] = 1;
    all.insert(all.end(), {many, skew, one_bright});
    return all;
}

TEST(Distribution, FindsWhatALinearSearchFinds) {
    using L = Lane<float, 16>;
    std::mt19937 rng(4);
    for (const auto& weights : cases()) {
        const Distribution d = make_distribution(weights);
        for (int k = 0; k < 500; ++k) {
            const L u([&](auto) { return float(rng() >> 8) * 0x1p-24f; });
            const Choice<L> c = choose(d, u);
            for (int i = 0; i < 16; ++i) {
                const int truth = search(d, lane(u, i));
                ASSERT_EQ(lane(c.index, i), truth);
                ASSERT_EQ(choose(d, lane(u, i)).index, truth);
                ASSERT_EQ(lane(c.probability, i), probability(d, truth));
                ASSERT_GT(weights[size_t(truth)], 0);
            }
        }
        for (const float u : d.cdf)  // exactly on the borders, and just below
            if (u < 1) {
                EXPECT_EQ(choose(d, u).index, search(d, u));
                if (u > 0) {
                    EXPECT_EQ(choose(d, u - 0x1p-24f).index, search(d, u - 0x1p-24f));
                }
            }
        EXPECT_EQ(choose(d, 1 - 0x1p-24f).index, search(d, 1 - 0x1p-24f));
    }
}

TEST(Distribution, ProbabilitiesAreExactUnitsOfTheGrid) {
    for (const auto& weights : cases()) {
        const Distribution d = make_distribution(weights);
        double total = 0, sum = 0;
        for (const double w : weights) total += w;
        for (int i = 0; i < d.size(); ++i) {
            const double p = probability(d, i), w = weights[size_t(i)] / total;
            EXPECT_EQ(p * 0x1p24, std::floor(p * 0x1p24));
            EXPECT_EQ(p > 0, weights[size_t(i)] > 0);
            EXPECT_NEAR(p, w, 2 * 0x1p-24 + w * double(weights.size()) * 0x1p-24);
            sum += p;
        }
        EXPECT_EQ(sum, 1);
    }
}

// A stratified u, (i + u) / n, can round up to 1.
TEST(Distribution, OneIsTheLastThing) {
    EXPECT_EQ((0x1.fffffep-1f + 3.0f) * 0.25f, 1.0f);
    for (const auto& weights : cases()) {
        const Distribution d = make_distribution(weights);
        EXPECT_EQ(choose(d, 1.0f).index, choose(d, 0x1.fffffep-1f).index);
        EXPECT_EQ(choose(d, 1.0f).probability, choose(d, 0x1.fffffep-1f).probability);
    }
}

TEST(Distribution, AMillionEqualLights) {
    const Distribution d = make_distribution(std::vector<double>(1000000, 1e-6));
    EXPECT_LE(d.steps, 2);
    for (int i = 0; i < d.size(); ++i) ASSERT_NEAR(probability(d, i), 1e-6, 1.1 * 0x1p-24);
}

TEST(Distribution, RefusesWhatHasNoMeaning) {
    for (const auto& bad : std::vector<std::vector<double>>{{}, {0, 0}, {1, -1}, {std::nan("")}, {INFINITY}})
        EXPECT_THROW(make_distribution(bad), Error);
}

}  // namespace
}  // namespace drt
