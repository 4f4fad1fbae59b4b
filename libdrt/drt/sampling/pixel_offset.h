#pragma once
// How the samples of neighbouring pixels are stratified together.
//
// If every pixel has scrambles of its own, errors of neighbours are independent: white noise. The eye, a blur and a
// denoiser average neighbours, so errors had better cancel among them, as blue noise does. So the 16 pixels of a block
// share key, shuffles and scrambles, and differ by an offset that is xored to the shuffled index. By itself, every
// pixel still sees an Owen-scrambled (0, 2)-sequence, so its error is what it was, at any number of samples; only
// together, few samples of neighbours fill the gaps between each other. The two replicates and the blocks
// stay independent, so A - B still tells the error.
//
// Ahmed and Wonka, "Screen-space blue-noise diffusion of Monte Carlo sampling error via hierarchical ordering of
// pixels", SIGGRAPH Asia 2020, let pixels in Z-order take consecutive pieces of one sequence; how long they are must be
// known before. Offsets need no such number. A pixel's is the sum of one for each bit of its place in Z-order; the
// four were chosen by the noise of blurred pictures and edges, so that nothing is lost where samples are many
// (docs/sampling.md). They are frozen: a change of one bit changes every picture.

#include <array>
#include <cstdint>

#include "drt/base/bits.h"

namespace drt {

inline constexpr int offset_block_bits = 2;  ///< blocks have 2^2 x 2^2 pixels

/// For bit b of a pixel's place in its block.
inline constexpr std::array<std::uint32_t, 4> place_offsets{0x78016b8f, 0x6adc3ecb, 0xd366d4ef, 0x97e8bef8};

namespace sampler_detail {

constexpr std::array<std::uint32_t, 16> make_pixel_offsets() {
    std::array<std::uint32_t, 16> out{};
    for (std::size_t place = 0; place < out.size(); ++place)
        for (std::size_t b = 0; b < place_offsets.size(); ++b)
            if (place >> b & 1u) out[place] ^= place_offsets[b];
    return out;
}

inline constexpr auto pixel_offsets = make_pixel_offsets();

}  // namespace sampler_detail

/// A pixel's place in its block in Z-order: 0..15.
template <class U>
constexpr U place_in_block(const U& x, const U& y) {
    return (x & U(1u)) | (y & U(1u)) << 1 | (x & U(2u)) << 1 | (y & U(2u)) << 2;
}

/// Only the lowest four bits of `place` matter.
template <class U>
[[gnu::always_inline]] inline U pixel_offset(const U& place) {
    return lookup_nibble(sampler_detail::pixel_offsets, place);
}

}  // namespace drt
