// The lanes' hand-written instructions against the scalar meaning of the same functions, for every width.

#include <gtest/gtest.h>

#include <random>

#include "drt/base/bits.h"

namespace drt {
namespace {

template <class L>
class Lanes : public ::testing::Test {};

struct Width4 {
    static constexpr int value = 4;
};
struct Width8 {
    static constexpr int value = 8;
};
struct Width16 {
    static constexpr int value = 16;
};
using Widths = ::testing::Types<Width4, Width8, Width16>;
TYPED_TEST_SUITE(Lanes, Widths);

template <class I>
I random_indices(std::mt19937& random, int limit) {
    std::uniform_int_distribution<int> any_index(0, limit - 1);
    return I([&](auto) { return any_index(random); });
}

TYPED_TEST(Lanes, GatherReadsEachLanesPlace) {
    using F = Lane<float, TypeParam::value>;
    using I = Lane<std::int32_t, TypeParam::value>;
    constexpr int size = 100;
    std::vector<float> floats(size + 3);
    std::vector<std::int32_t> ints(size);
    for (int i = 0; i < size + 3; ++i) floats[size_t(i)] = 0.25f * float(i);
    for (int i = 0; i < size; ++i) ints[size_t(i)] = 7 * i - 50;
    std::mt19937 random(5);
    for (int round = 0; round < 50; ++round) {
        // one index for all lanes in every other round: the coherent gather's short cut
        const I at = round % 2 == 0 ? I(round) : random_indices<I>(random, size);
        const F f = gather<F>(floats.data(), at), fc = gather_coherent<F>(floats.data(), at);
        const I n = gather<I>(ints.data(), at), nc = gather_coherent<I>(ints.data(), at);
        const auto quads = gather_quads<F>(floats.data(), at);
        for (int l = 0; l < width_of<F>; ++l) {
            const int i = lane(at, l);
            EXPECT_EQ(lane(f, l), 0.25f * float(i));
            EXPECT_EQ(lane(fc, l), 0.25f * float(i));
            EXPECT_EQ(lane(n, l), 7 * i - 50);
            EXPECT_EQ(lane(nc, l), 7 * i - 50);
            for (int k = 0; k < 4; ++k) EXPECT_EQ(lane(quads[size_t(k)], l), 0.25f * float(i + k));
        }
    }
}

TYPED_TEST(Lanes, NibbleLookupAndBitReversal) {
    using U = Lane<std::uint32_t, TypeParam::value>;
    std::mt19937 random(6);
    std::array<std::uint32_t, 16> table;
    for (auto& v : table) v = std::uint32_t(random());
    for (int round = 0; round < 50; ++round) {
        const U v([&](auto) { return std::uint32_t(random()); });
        const U looked_up = lookup_nibble(table, v), reversed = reverse_bits(v);
        for (int l = 0; l < width_of<U>; ++l) {
            EXPECT_EQ(lane(looked_up, l), table[lane(v, l) & 15u]);
            EXPECT_EQ(lane(reversed, l), reverse_bits(lane(v, l)));
        }
    }
}

TYPED_TEST(Lanes, ReciprocalsAreWithinTheirError) {
    using F = Lane<float, TypeParam::value>;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-100, 100);
    double worst_root = 0, worst_inverse = 0;
    for (int round = 0; round < 20000; ++round) {
        const F x([&](auto) { return std::exp2(exponent(random)); });
        const F root = inverse_sqrt(x), inverse = reciprocal(F(-x));
        for (int l = 0; l < width_of<F>; ++l) {
            const double v = double(lane(x, l));
            worst_root = std::max(worst_root, std::abs(double(lane(root, l)) * std::sqrt(v) - 1));
            worst_inverse = std::max(worst_inverse, std::abs(double(lane(inverse, l)) * v + 1));
        }
    }
    EXPECT_LT(worst_root, 2e-7);
    EXPECT_LT(worst_inverse, 2e-7);
}

}  // namespace
}  // namespace drt
