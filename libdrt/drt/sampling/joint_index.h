#pragma once
// How dimensions are stratified together.
//
// Shuffling the index of each dimension by itself ("padding") makes dimensions independent, and everything that depends
// on two of them at once, lens and light, say, converges like random sampling or slower. So four 2D dimensions share
// one shuffled index s, and the k-th of them uses M_k s in its place: M_k is an upper unitriangular bit matrix, so
// every 2D set stays a (0, 2)-sequence on its own (the generator matrices (I, Pascal) M_k are those of the Sobol pair
// with the columns mixed), and the M_k are chosen so that the 4D sets of any two of them are as evenly spread as a
// search could find. The idea follows Ahmed et al., "SZ Sequences: Binary-Constructed (0, 2^q)-Sequences" (SIGGRAPH
// Asia 2024), whose M_k are powers of Pascal matrices over GF(2^q); those are better only at powers of 2^q.
// docs/sampling.md has the figures, tests/sampling/joint_index_study.cpp the search.

#include <array>
#include <cstdint>

#include "drt/base/bits.h"

namespace drt {

inline constexpr int joint_dims = 4;      ///< 2D dimensions that share an index
inline constexpr int joint_columns = 12;  ///< the M_k mix the first 12 bits: blocks of 4096 samples

/// Column b of M_k: what bit b of the index turns into. M_0 is the identity.
inline constexpr std::array<std::array<std::uint32_t, joint_columns>, joint_dims> joint_matrices{{
    {0x1, 0x2, 0x4, 0x8, 0x10, 0x20, 0x40, 0x80, 0x100, 0x200, 0x400, 0x800},
    {0x1, 0x3, 0x7, 0xd, 0x12, 0x27, 0x5d, 0xee, 0x14f, 0x2b7, 0x44b, 0xe9a},
    {0x1, 0x3, 0x6, 0xf, 0x1c, 0x32, 0x49, 0xe6, 0x18c, 0x24d, 0x535, 0xce1},
    {0x1, 0x2, 0x5, 0xb, 0x13, 0x3c, 0x79, 0xce, 0x128, 0x3fd, 0x42b, 0x95c},
}};

namespace sampler_detail {

/// (M_k + identity) times every value of four neighbouring index bits.
using NibbleTable = std::array<std::uint32_t, 16>;

constexpr std::array<std::array<NibbleTable, joint_columns / 4>, joint_dims> make_joint_changes() {
    std::array<std::array<NibbleTable, joint_columns / 4>, joint_dims> out{};
    for (size_t k = 0; k < joint_dims; ++k)
        for (size_t b = 0; b < joint_columns; ++b)
            for (size_t v = 0; v < 16; ++v)
                if (v >> (b % 4) & 1) out[k][b / 4][v] ^= joint_matrices[k][b] ^ (1u << b);
    return out;
}

inline constexpr auto joint_changes = make_joint_changes();

}  // namespace sampler_detail

/// M_slot times the bits of the index; slot in 0..3.
template <class U>
[[gnu::always_inline]] inline U joint_index(const U& index, int slot) {
    if (slot == 0) return index;
    const auto& changes = sampler_detail::joint_changes[size_t(slot)];
    return index ^ lookup_nibble(changes[0], index) ^ lookup_nibble(changes[1], U(index >> 4)) ^
           lookup_nibble(changes[2], U(index >> 8));
}

}  // namespace drt
