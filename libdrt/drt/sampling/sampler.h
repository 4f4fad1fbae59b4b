#pragma once
// Sample points: a pure function of (seed, frame, pixel, replicate, index, named dimension). No state anywhere.
//
// Every named dimension is a 2D point set: an Owen-scrambled Sobol (0, 2)-sequence, with hashes for the scrambles after
// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. A path's dimensions in the order of its events
// (filter, lens, time, bounce 0, bounce 1, ...) are stratified jointly in fours (joint_index.h); the fours have
// independently shuffled indices. Because a dimension is found by its name (dimension.h), a plan that does not draw one
// never shifts the others. Neighbouring pixels are stratified with each other as well (pixel_offset.h). Nothing depends
// on the number of samples that will be taken.
//
// All of this is frozen: a change of a single bit changes every picture (docs/sampling.md).

#include <cstdint>

#include "drt/base/bits.h"
#include "drt/base/vec.h"
#include "drt/sampling/dimension.h"
#include "drt/sampling/hash.h"
#include "drt/sampling/joint_index.h"
#include "drt/sampling/pixel_offset.h"

namespace drt {

enum class SamplerKind {
    sobol,        ///< the renderer's
    independent,  ///< uncorrelated hashes: for tests and as a yardstick
};

/// Names a sample of a pixel. `T` is float or double, scalar or lanes.
template <class T>
struct SampleSet {
    using U = Rebind<T, std::uint32_t>;
    U key;             ///< of the pixel's block, from sample_key()
    U index;           ///< number of the sample within its replicate, from 0
    U offset = U(0u);  ///< the pixel's, from pixel_offset()
};

/// The key of the block of pixels in column x and row y of blocks: well mixed, so that blocks, frames, seeds and
/// replicates are independent.
template <class U>
[[gnu::always_inline]] inline U sample_key(std::uint32_t seed, std::uint32_t frame, std::uint32_t replicate, const U& x,
                                           const U& y) {
    const std::uint32_t image = hash_combine(hash_combine(mix_bits(seed), frame), replicate);
    return hash_combine(hash_combine(U(image), x), y);
}

/// Sample `index` of a pixel.
template <class T, class U = Rebind<T, std::uint32_t>>
[[gnu::always_inline]] inline SampleSet<T> pixel_sample(std::uint32_t seed, std::uint32_t frame,
                                                        std::uint32_t replicate, const U& x, const U& y,
                                                        const U& index) {
    const U key = sample_key<U>(seed, frame, replicate, x >> offset_block_bits, y >> offset_block_bits);
    return {key, index, pixel_offset(place_in_block(x, y))};
}

/// Bits to [0, 1): the upper 24 for float (32 could round up to 1), all 32 for double.
template <class T>
[[gnu::always_inline]] inline T unit_interval(const Rebind<T, std::uint32_t>& bits) {
    if constexpr (std::is_same_v<ScalarOf<T>, float>)
        return num_cast<T>(num_cast<Rebind<T, std::int32_t>>(Rebind<T, std::uint32_t>(bits >> 8))) * T(0x1p-24f);
    else
        return num_cast<T>(bits) * T(0x1p-32);
}

/// Owen's nested uniform scrambling in base 2, of a number whose bits are reversed: every bit is flipped by a hash of
/// the bits below it. Laine and Karras' kind of hash with Vegdahl's constants
/// (psychopath.io/post/2021_01_30_building_a_better_lk_hash).
template <class U>
[[gnu::always_inline]] inline U owen_scramble_reversed(U v, const U& key) {
    v ^= v * U(0x3d20adeau);
    v += key;
    v *= (key >> 16) | U(1u);
    v ^= v * U(0x05526c56u);
    v ^= v * U(0x53a22864u);
    return v;
}

/// The generator matrix of Sobol's second dimension applied to an index: the Pascal triangle modulo 2, whose entry
/// (i, j) is 1 where the bits of i are a subset of those of j (Lucas). So digit i is the sum of the index' bits over
/// all supersets of i: five masked shifts. Bit 0 of the result is the first digit after the binary point.
template <class U>
[[gnu::always_inline]] inline U sobol_second_digits(U index) {
    index ^= (index >> 1) & U(0x55555555u);
    index ^= (index >> 2) & U(0x33333333u);
    index ^= (index >> 4) & U(0x0f0f0f0fu);
    index ^= (index >> 8) & U(0x00ff00ffu);
    index ^= index >> 16;
    return index;
}

namespace sampler_detail {

/// Keys of a dimension's two scrambles.
template <class U>
struct ScrambleKeys {
    U x, y;
};

template <class U>
[[gnu::always_inline]] inline ScrambleKeys<U> scramble_keys(const U& key, DimId dim) {
    const U h = hash_combine(key, U(mix_bits(dim + 0x68e31da4u)));
    return {h, mix_bits(U(h + U(0x1b56c4e9u)))};
}

/// x and y of SamplerKind::independent, before scrambling.
template <class U>
[[gnu::always_inline]] inline U independent_bits(const U& index, const U& scramble_key) {
    return mix_bits(hash_combine(scramble_key, index));
}

}  // namespace sampler_detail

/// A sample set as the dimensions of one group see it: its index is shuffled and has the pixel's offset.
template <class T>
struct GroupSamples {
    using U = Rebind<T, std::uint32_t>;
    U key, index;
};

/// A sample set as the dimensions of one joint slot see it: what those that share a slot, all lights of a hit, say,
/// have in common.
template <class T>
struct SlotSamples {
    using U = Rebind<T, std::uint32_t>;
    U key;
    U index;  ///< within the slot's point set
};

/// Owen-shuffled: every aligned block of 2^k samples maps to an aligned block of 2^k. Only here pixels of a block go
/// different ways.
template <class T>
[[gnu::always_inline]] inline GroupSamples<T> in_group(SamplerKind kind, const SampleSet<T>& set, DimId dimension) {
    using U = Rebind<T, std::uint32_t>;
    if (kind == SamplerKind::independent) return {set.key, U(set.index ^ set.offset)};
    const U shuffle = hash_combine(set.key, U(mix_bits(joint_slot(dimension).group + 0xb5297a4du)));
    return {set.key, U(reverse_bits(owen_scramble_reversed(reverse_bits(set.index), shuffle)) ^ set.offset)};
}

/// The dimension must be of the group.
template <class T>
[[gnu::always_inline]] inline SlotSamples<T> at_slot(SamplerKind kind, const GroupSamples<T>& set, DimId dimension) {
    if (kind == SamplerKind::independent) return {set.key, set.index};
    return {set.key, joint_index(set.index, joint_slot(dimension).slot)};
}

template <class T>
[[gnu::always_inline]] inline SlotSamples<T> at_slot(SamplerKind kind, const SampleSet<T>& set, DimId dimension) {
    return at_slot(kind, in_group(kind, set, dimension), dimension);
}

// Always inlined: with kind and dimension known, the branches go, the matrix becomes constants and dimensions of a
// group share their index; two to three times as fast.

/// A point of the unit square as digits: the first one after the binary point is the highest bit.
template <class T>
struct PointDigits {
    using U = Rebind<T, std::uint32_t>;
    U x, y;
};

/// Owen-scrambled Sobol.
template <class T>
[[gnu::always_inline]] inline PointDigits<T> scrambled_digits(const SlotSamples<T>& set, DimId dimension) {
    using U = Rebind<T, std::uint32_t>;
    const auto keys = sampler_detail::scramble_keys<U>(set.key, dimension);
    // Sobol's first dimension is the bit-reversed index, so its digits, first digit in bit 0, are the index itself.
    return {reverse_bits(owen_scramble_reversed(set.index, keys.x)),
            reverse_bits(owen_scramble_reversed(sobol_second_digits(set.index), keys.y))};
}

/// In [0, 1) x [0, 1): never 1, also not after rounding to float. Every aligned power-of-two block of indices is a
/// (0, k, 2)-net. The same bits for scalars and lanes of every width.
template <class T>
[[gnu::always_inline]] inline Vec2<T> sample_2d(SamplerKind kind, const SlotSamples<T>& set, DimId dimension) {
    using U = Rebind<T, std::uint32_t>;
    using namespace sampler_detail;
    if (kind == SamplerKind::independent) {
        const auto keys = scramble_keys<U>(set.key, dimension);
        return {unit_interval<T>(independent_bits(set.index, keys.x)),
                unit_interval<T>(independent_bits(set.index, keys.y))};
    }
    const PointDigits<T> p = scrambled_digits(set, dimension);
    return {unit_interval<T>(p.x), unit_interval<T>(p.y)};
}

/// The sample set's point for one of many terms that are only added (the lights of a hit): the digits that all of them
/// share, shifted by a hash of the dimension, a third of the price of scrambles of its own. Each term sees a scrambled
/// net; the shift is uniform over the square (to 16 digits an axis), so for any f and g the mean over shifts of
/// f(p) g(q + shift) is the product of the integrals: the errors of the terms stay uncorrelated.
template <class T>
[[gnu::always_inline]] inline Vec2<T> shifted_point(const PointDigits<T>& p, const Rebind<T, std::uint32_t>& key,
                                                    DimId dimension) {
    using U = Rebind<T, std::uint32_t>;
    const U shift = hash_combine(key, U(mix_bits(dimension + 0x85ebca6bu)));
    return {unit_interval<T>(U(p.x ^ shift)), unit_interval<T>(U(p.y ^ (shift << 16 | shift >> 16)))};
}

/// The dimension by itself.
template <class T>
[[gnu::always_inline]] inline Vec2<T> sample_2d(SamplerKind kind, const SampleSet<T>& set, DimId dimension) {
    return sample_2d(kind, at_slot(kind, set, dimension), dimension);
}

/// In [0, 1): the x of sample_2d.
template <class T>
[[gnu::always_inline]] inline T sample_1d(SamplerKind kind, const SlotSamples<T>& set, DimId dimension) {
    using U = Rebind<T, std::uint32_t>;
    using namespace sampler_detail;
    const U key = scramble_keys<U>(set.key, dimension).x;
    if (kind == SamplerKind::independent) return unit_interval<T>(independent_bits(set.index, key));
    return unit_interval<T>(reverse_bits(owen_scramble_reversed(set.index, key)));
}

/// The dimension by itself.
template <class T>
[[gnu::always_inline]] inline T sample_1d(SamplerKind kind, const SampleSet<T>& set, DimId dimension) {
    return sample_1d(kind, at_slot(kind, set, dimension), dimension);
}

}  // namespace drt
