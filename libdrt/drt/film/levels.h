#pragma once
// Exact sums of floats. A float is an integer of 24 bits times a power of two, so floats whose exponents lie within
// sixteen octaves, a level, are integers below 2^39 of one unit, and 2^24 of them add up in 64 bits without rounding,
// in any order. Sixteen levels hold every float. (A superaccumulator: Neal 2015, Fast exact summation using small and
// large superaccumulators; here without carries from level to level, which the number of samples makes unnecessary.)

#include <bit>
#include <cstdint>

#include "drt/base/simd.h"

namespace drt {

inline constexpr int level_count = 16, level_octaves = 16;
/// The level of most light: from 2^-10 to below 2^6. Zeros are of every level.
inline constexpr int ordinary_level = 7;
/// So many values may be added to one sum.
inline constexpr std::uint64_t most_summands = std::uint64_t(1) << 24;

namespace level_detail {
constexpr int first_exponent = 5;  ///< biased, of level 0: chosen for where the ordinary level comes to lie
constexpr int exponent_bias = 127, fraction_bits = 23;
}  // namespace level_detail

/// The bits of the smallest magnitude of a level. One level further: infinity. Numbers below 2^-122, the first of
/// level 0, are counted in it and rounded to its unit, 2^-145.
constexpr std::int32_t first_bits(int level) {
    if (level <= 0) return 1;
    if (level >= level_count) return 0x7f800000;
    return (level * level_octaves + level_detail::first_exponent) << level_detail::fraction_bits;
}

/// The level of a magnitude's bits, of a float or of lanes.
template <class I>
[[gnu::always_inline]] inline I level_of(const I& bits) {
    using namespace level_detail;
    return max(I((bits >> fraction_bits) - I(first_exponent)), I(0)) >> std::countr_zero(unsigned(level_octaves));
}

/// Units in 1: a power of two.
constexpr double level_scale(int level) {
    const int unit = level * level_octaves + level_detail::first_exponent - level_detail::exponent_bias -
                     level_detail::fraction_bits;
    return std::bit_cast<double>(std::uint64_t(1023 - unit) << 52);
}

static_assert(first_bits(ordinary_level) == std::bit_cast<std::int32_t>(0x1p-10f));
static_assert(first_bits(ordinary_level + 1) == std::bit_cast<std::int32_t>(0x1p6f));
static_assert(level_scale(ordinary_level) == 0x1p33);

}  // namespace drt
