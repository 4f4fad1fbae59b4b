// The pixels of a block: each by itself as if it were alone, together less noisy once they are blurred.

#include "drt/sampling/pixel_offset.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "drt/base/constants.h"
#include "drt/sampling/sampler.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::Mean;

constexpr std::uint32_t side = 1u << offset_block_bits, pixels = side * side;

constexpr std::array<DimId, 6> dimensions{dim(PathDim::filter),  dim(PathDim::lens),   dim(PathDim::time),
                                          dim(HitDim::light, 0), dim(HitDim::lobe, 2), dim(HitDim::lobe_choice, 1)};

/// Of a pixel of block `block`.
SampleSet<double> sample(std::uint32_t block, std::uint32_t x, std::uint32_t y, std::uint32_t index) {
    return pixel_sample<double>(1, 0, 0, side * block + x, 4 * side + y, index);
}

TEST(PixelOffset, PlacesAreInZOrder) {
    std::set<std::uint32_t> places;
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) places.insert(place_in_block(x, y));
    EXPECT_EQ(places.size(), pixels);
    EXPECT_EQ(place_in_block(4u + 3u, 8u + 2u), 13u);
}

TEST(PixelOffset, EveryPixelSeesNets) {
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel)
        for (int k = 0; k <= 7; ++k)
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < 1u << k; ++i) {
                    const Vec2d p = sample_2d(SamplerKind::sobol, sample(7, pixel % side, pixel / side, i),
                                              dimensions[pixel % dimensions.size()]);
                    cells.insert({int(p.x * (1 << a)), int(p.y * (1 << (k - a)))});
                }
                ASSERT_EQ(cells.size(), size_t(1) << k) << "pixel " << pixel << ", k " << k << ", split " << a;
            }
}

/// A straight edge through the square: 1 on one side of it.
struct Edge {
    Vec2d n;
    double c = 0;
    bool mirrored = false;

    double operator()(Vec2d p) const { return n.x * (mirrored ? 1 - p.x : p.x) + n.y * p.y < c ? 1 : 0; }
    double area() const {
        const auto square = [](double v) { return v > 0 ? v * v : 0; };
        return (square(c) - square(c - n.x) - square(c - n.y) + square(c - n.x - n.y)) / (2 * n.x * n.y);
    }
};

/// Another one for each block.
Edge edge(std::uint32_t block) {
    const auto random = [&](std::uint32_t i) { return (mix_bits(hash_combine(block, i)) + 0.5) * 0x1p-32; };
    const double angle = pi<double> / 2 * random(0);
    const Vec2d n{std::cos(angle), std::sin(angle)};
    return {n, n.x * random(1) + n.y * random(2), random(3) < 0.5};
}

using Errors = std::array<double, pixels>;

Errors errors(std::uint32_t block, DimId d, std::uint32_t spp) {
    const Edge f = edge(block);
    Errors out{};
    for (std::uint32_t p = 0; p < pixels; ++p) {
        for (std::uint32_t i = 0; i < spp; ++i)
            out[p] += f(sample_2d(SamplerKind::sobol, sample(block, p % side, p / side, i), d));
        out[p] = out[p] / spp - f.area();
    }
    return out;
}

/// What a Gaussian of sigma 1 pixel leaves of the squared errors of pixels of a block.
double blurred_square(const Errors& errors) {
    double sum = 0;
    for (int p = 0; p < int(pixels); ++p)
        for (int q = 0; q < int(pixels); ++q) {
            const int dx = p % int(side) - q % int(side), dy = p / int(side) - q / int(side);
            sum += std::exp(-(dx * dx + dy * dy) / 4.0) * errors[size_t(p)] * errors[size_t(q)];
        }
    return sum / pixels;
}

double square(const Errors& errors) {
    double sum = 0;
    for (const double e : errors) sum += e * e;
    return sum / pixels;
}

TEST(PixelOffset, BlurredErrorsOfEdgesAreSmaller) {
    // Variance against independent pixels, over all dimensions: 0.62 0.62 0.71 0.62 0.64 0.61 0.74 0.79 for 1, 2, 4,
    // ... samples of a replicate, all edges being the same in the whole block.
    const std::pair<std::uint32_t, double> most[] = {{1, 0.7},  {2, 0.7},  {4, 0.8},  {8, 0.7},
                                                     {16, 0.7}, {32, 0.7}, {64, 0.8}, {128, 0.85}};
    for (const auto& [spp, limit] : most) {
        Mean blurred, alone;
        for (const DimId d : dimensions)
            for (std::uint32_t block = 0; block < 1000; ++block) {
                const Errors e = errors(block, d, spp);
                blurred.add(blurred_square(e));
                alone.add(square(e));
            }
        EXPECT_LT(blurred.mean(), limit * alone.mean()) << spp << " samples";
    }
}

TEST(PixelOffset, PixelsByThemselvesAreAsGoodAsEver) {
    // The mean square of each pixel's error is that of the first one, which has offset 0, within four sigma.
    std::array<Mean, pixels> squares;
    for (std::uint32_t block = 0; block < 4000; ++block) {
        const Errors e = errors(block, dimensions[3], 8);
        for (size_t p = 0; p < pixels; ++p) squares[p].add(e[p] * e[p]);
    }
    for (size_t p = 1; p < pixels; ++p)
        EXPECT_NEAR(squares[p].mean(), squares[0].mean(), 4 * std::hypot(squares[p].error(), squares[0].error()));
}

TEST(PixelOffset, BlocksAreIndependent) {
    // Neighbours across the edge between two blocks: no covariance within four sigma.
    const Edge f{{0.8, 0.6}, 0.7, false};
    Mean product;
    for (std::uint32_t block = 0; block < 20000; ++block) {
        double left = 0, right = 0;
        for (std::uint32_t i = 0; i < 8; ++i) {
            left += f(sample_2d(SamplerKind::sobol, sample(block, side - 1, 1, i), dimensions[3])) - f.area();
            right += f(sample_2d(SamplerKind::sobol, sample(block + 1, 0, 1, i), dimensions[3])) - f.area();
        }
        product.add(left * right);
    }
    EXPECT_LT(std::abs(product.mean()), 4 * product.error());
}

}  // namespace
}  // namespace drt
