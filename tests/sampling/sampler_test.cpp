#include "drt/sampling/sampler.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <set>

#include "drt/base/constants.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::Mean;

constexpr DimId lens = dim(PathDim::lens), light = dim(HitDim::light, 0);

std::uint32_t pixel_key(std::uint32_t x, std::uint32_t y = 0, std::uint32_t replicate = 0, std::uint32_t seed = 1) {
    return sample_key<std::uint32_t>(seed, 0, replicate, x, y);
}

Vec2d sobol(std::uint32_t key, std::uint32_t index, DimId d) {
    return sample_2d(SamplerKind::sobol, SampleSet<double>{key, index}, d);
}

/// Bit i of the second Sobol coordinate by the definition: direction numbers of the polynomial x + 1.
std::uint32_t sobol_second_slow(std::uint32_t index) {
    std::uint32_t v = 0x80000000u, y = 0;
    for (int i = 0; i < 32; ++i, v ^= v >> 1)
        if (index >> i & 1) y ^= v;
    return y;
}

TEST(Bits, ReverseIsTheDefinition) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const std::uint32_t v = mix_bits(i);
        std::uint32_t r = 0;
        for (int b = 0; b < 32; ++b) r |= (v >> b & 1u) << (31 - b);
        EXPECT_EQ(reverse_bits(v), r);
    }
}

TEST(Sobol, SecondDimensionIsTheDirectionNumbers) {
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const std::uint32_t v = i < 500 ? i : mix_bits(i);
        EXPECT_EQ(reverse_bits(sobol_second_digits(v)), sobol_second_slow(v));
    }
}

TEST(Sobol, OwenScrambleIsNested) {
    // Flipping bit b of the reversed number may change only bits b and above (the less significant digits).
    for (std::uint32_t i = 0; i < 200; ++i)
        for (int b = 0; b < 32; ++b) {
            const std::uint32_t v = mix_bits(i), key = mix_bits(i + 1000);
            const std::uint32_t change = owen_scramble_reversed(v, key) ^ owen_scramble_reversed(v ^ (1u << b), key);
            EXPECT_EQ(change & ((2u << b) - 1u), 1u << b);
        }
}

TEST(Sobol, EveryAlignedBlockIsANet) {
    // (0, k, 2)-net: every elementary interval of area 2^-k holds exactly one of 2^k points.
    for (int k = 0; k <= 10; ++k)
        for (std::uint32_t trial = 0; trial < 8; ++trial) {
            const DimId dims[] = {lens, light, dim(PathDim::filter), dim(PathDim::time)};
            const std::uint32_t key = pixel_key(trial), first = trial % 3 << k;
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = first; i < first + (1u << k); ++i) {
                    const Vec2d p = sobol(key, i, dims[trial % 4]);
                    cells.insert({int(p.x * (1 << a)), int(p.y * (1 << (k - a)))});
                }
                ASSERT_EQ(cells.size(), size_t(1) << k) << "k " << k << ", split " << a << ", trial " << trial;
            }
        }
}

TEST(Sampler, FloatIsBelowOne) {
    EXPECT_EQ(unit_interval<float>(0xffffffffu), 1.0f - 0x1p-24f);
    EXPECT_EQ(unit_interval<double>(0xffffffffu), 1.0 - 0x1p-32);
    EXPECT_EQ(unit_interval<float>(0u), 0.0f);
}

template <class T>
void expect_lanes_equal_scalars() {
    using S = ScalarOf<T>;
    using U = Rebind<T, std::uint32_t>;
    constexpr int W = width_of<T>;
    for (const auto kind : {SamplerKind::sobol, SamplerKind::independent})
        for (std::uint32_t first = 0; first < 256; first += W) {
            const U x([&](auto i) { return first + std::uint32_t(i); }), y(first / 7);
            const SampleSet<T> set = pixel_sample<T>(3, 4, 1, x, y, U(x * 3u));
            const Vec2<T> p = sample_2d<T>(kind, set, light);
            const T q = sample_1d<T>(kind, set, lens);
            for (int i = 0; i < W; ++i) {
                const std::uint32_t column = first + std::uint32_t(i);
                const SampleSet<S> one = pixel_sample<S>(3, 4, 1, column, first / 7, column * 3u);
                ASSERT_EQ(lane(set.key, i), one.key);
                ASSERT_EQ(lane(set.offset, i), one.offset);
                ASSERT_EQ(lane(p.x, i), sample_2d<S>(kind, one, light).x);
                ASSERT_EQ(lane(p.y, i), sample_2d<S>(kind, one, light).y);
                ASSERT_EQ(lane(q, i), sample_2d<S>(kind, one, lens).x);
            }
        }
}

TEST(Sampler, LanesGiveTheBitsOfScalars) {
    expect_lanes_equal_scalars<Lane<float, 4>>();
    expect_lanes_equal_scalars<Lane<float, 8>>();
    expect_lanes_equal_scalars<Lane<float, 16>>();
    expect_lanes_equal_scalars<Lane<double, 4>>();
    expect_lanes_equal_scalars<Lane<double, 8>>();
}

// ---- randomness across pixels, replicates, dimensions
// -----------------------------------------------------------------

/// The p-value of the joint histogram of (a(pixel), b(pixel)) over 2^18 pixels against uniform on a 16 x 16 grid.
double independence(const std::function<double(std::uint32_t)>& a, const std::function<double(std::uint32_t)>& b) {
    constexpr std::uint32_t n = 1u << 18;
    std::vector<double> counts(256), expected(256, n / 256.0);
    for (std::uint32_t i = 0; i < n; ++i) counts[size_t(a(i) * 16) * 16 + size_t(b(i) * 16)] += 1;
    return test::chi2_p_value(counts, expected);
}

TEST(Sampler, PixelsReplicatesAndDimensionsAreIndependent) {
    const double level = test::sidak(0.01, 2 * 8);
    for (const auto kind : {SamplerKind::sobol, SamplerKind::independent}) {
        const auto at = [&](std::uint32_t key, std::uint32_t index, DimId d) {
            return sample_2d(kind, SampleSet<double>{key, index}, d);
        };
        const auto base = [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9), 0, lens).x; };
        const std::array<std::function<double(std::uint32_t)>, 8> others{
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9), 0, lens).y; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9), 0, light).x; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9), 0, dim(HitDim::light, 0, 1)).x; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9), 0, dim(HitDim::light, 1, 0)).x; },
            [&](std::uint32_t i) { return at(pixel_key((i & 511) + 1, i >> 9), 0, lens).x; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, (i >> 9) + 1), 0, lens).x; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9, 1), 0, lens).x; },
            [&](std::uint32_t i) { return at(pixel_key(i & 511, i >> 9, 0, 2), 0, lens).x; }};
        for (size_t k = 0; k < others.size(); ++k) EXPECT_GT(independence(base, others[k]), level) << k;
    }
}

TEST(Sampler, EachPointIsUniformOverScrambles) {
    // Over pixels, the third point of a set is uniform on the square: 64 x 64 bins.
    for (const auto kind : {SamplerKind::sobol, SamplerKind::independent}) {
        constexpr int n = 1 << 19, bins = 64;
        std::vector<double> counts(bins * bins), expected(bins * bins, double(n) / (bins * bins));
        for (std::uint32_t i = 0; i < n; ++i) {
            const Vec2<float> p = sample_2d(kind, SampleSet<float>{pixel_key(i & 1023, i >> 10), 3}, light);
            counts[size_t(p.x * bins) * bins + size_t(p.y * bins)] += 1;
        }
        EXPECT_GT(test::chi2_p_value(counts, expected), test::sidak(0.01, 2));
    }
}

// ---- convergence
// ------------------------------------------------------------------------------------------------------

/// RMS error of the mean of f(two dimensions of a set) over `spp` points, over 400 scrambles.
double rms_error(SamplerKind kind, int spp, double truth, const std::function<double(Vec2d, Vec2d)>& f) {
    Mean squares;
    for (std::uint32_t pixel = 0; pixel < 400; ++pixel) {
        double sum = 0;
        for (std::uint32_t i = 0; i < std::uint32_t(spp); ++i) {
            const SampleSet<double> set{pixel_key(pixel, 77), i};
            sum += f(sample_2d(kind, set, lens), sample_2d(kind, set, light));
        }
        squares.add((sum / spp - truth) * (sum / spp - truth));
    }
    return std::sqrt(squares.mean());
}

double gain(int spp, double truth, const std::function<double(Vec2d, Vec2d)>& f) {
    return rms_error(SamplerKind::independent, spp, truth, f) / rms_error(SamplerKind::sobol, spp, truth, f);
}

TEST(Sobol, ConvergesMuchFasterThanRandom) {
    const auto smooth = [](Vec2d a, Vec2d) { return std::sin(pi<double> * a.x) * a.y; };
    const auto edge = [](Vec2d a, Vec2d) { return a.x + 0.6 * a.y < 0.7 ? 1.0 : 0.0; };
    // A smooth function gains sqrt(n) and more in 2D, a straight edge about n^1/4 (docs/sampling.md).
    EXPECT_GT(gain(64, 1 / pi<double>, smooth), 15);
    EXPECT_GT(gain(256, 1 / pi<double>, smooth), 40);
    EXPECT_GT(gain(64, 0.4, edge), 3);
    EXPECT_GT(gain(1024, 0.4, edge), 6);
}

/// The point of light `number` of a pixel's sample `index`.
Vec2d light_point(std::uint32_t pixel, std::uint32_t index, int number) {
    const std::uint32_t key = pixel_key(pixel, 5);
    const auto samples = at_slot(SamplerKind::sobol, SampleSet<double>{key, index}, light);
    return shifted_point(scrambled_digits(samples, light), key, dim(HitDim::light, 0, number));
}

TEST(Sobol, PointsOnAllLightsOfAHitAreNets) {
    for (int k = 0; k <= 8; ++k)
        for (int number = 0; number < 4; ++number)
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < 1u << k; ++i) {
                    const Vec2d p = light_point(9, i, number);
                    cells.insert({int(p.x * (1 << a)), int(p.y * (1 << (k - a)))});
                }
                ASSERT_EQ(cells.size(), size_t(1) << k) << "k " << k << ", split " << a << ", light " << number;
            }
}

TEST(Sobol, ErrorsOfTheLightsOfAHitAreUncorrelated) {
    // 8 samples of two lights, over 2^15 pixels: smooth terms, an edge, and the same point of each (the worst case).
    const auto smooth = [](Vec2d p) { return p.x * p.x + std::sin(3 * p.y); };
    const auto edge = [](Vec2d p) { return p.x + 0.6 * p.y < 0.7 ? 1.0 : 0.0; };
    const auto corner = [](Vec2d p) { return p.x < 0.1 && p.y < 0.3 ? 1.0 : 0.0; };
    constexpr int pixels = 1 << 15;
    for (const std::function<double(Vec2d)>& f : {std::function<double(Vec2d)>(smooth), {edge}, {corner}})
        for (const int other : {1, 7}) {
            Mean x, y, xx, yy, xy;
            for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
                double a = 0, b = 0;
                for (std::uint32_t i = 0; i < 8; ++i)
                    a += f(light_point(pixel, i, 0)), b += f(light_point(pixel, i, other));
                x.add(a), y.add(b), xx.add(a * a), yy.add(b * b), xy.add(a * b);
            }
            const double covariance = xy.mean() - x.mean() * y.mean();
            const double variance = std::sqrt((xx.mean() - x.mean() * x.mean()) * (yy.mean() - y.mean() * y.mean()));
            EXPECT_LT(std::abs(covariance / variance), 4 / std::sqrt(pixels));  // 6 cases: one false alarm in 2600
        }
}

TEST(Sobol, JointDimensionsConvergeTogether) {
    // Lens against light at the first hit: neither an interaction nor an edge in 4D may converge as slowly as padded
    // dimensions do (0.8, 0.9 and 1.9 times as precise as random, at every spp).
    const auto product = [](Vec2d a, Vec2d b) { return (a.x - 0.5) * (b.x - 0.5); };
    const auto edge = [](Vec2d a, Vec2d b) { return a.x + a.y + b.x + b.y < 2 ? 1.0 : 0.0; };
    EXPECT_GT(gain(16, 0, product), 2);
    EXPECT_GT(gain(256, 0, product), 5);
    EXPECT_GT(gain(16, 0.5, edge), 1.6);
    EXPECT_GT(gain(256, 0.5, edge), 1.75);
}

TEST(Sobol, LightsThatShareASlotHaveIndependentErrors) {
    // The covariance of the errors of two lights' terms, over scrambles, is zero within four sigma.
    const DimId second = dim(HitDim::light, 0, 1);
    Mean product;
    const auto f = [](Vec2d p) { return p.x + 0.6 * p.y < 0.7 ? 1.0 : 0.0; };
    for (std::uint32_t pixel = 0; pixel < 20000; ++pixel) {
        double a = 0, b = 0;
        for (std::uint32_t i = 0; i < 16; ++i) {
            a += f(sobol(pixel_key(pixel, 5), i, light)) - 0.4;
            b += f(sobol(pixel_key(pixel, 5), i, second)) - 0.4;
        }
        product.add(a * b);
    }
    EXPECT_LT(std::abs(product.mean()), 4 * product.error());
}

}  // namespace
}  // namespace drt
