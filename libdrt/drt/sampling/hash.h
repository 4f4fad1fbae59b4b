#pragma once
// Integer hashes, for scalars and lanes. U holds std::uint32_t.

#include "drt/base/simd.h"

namespace drt {

/// A bijection of 32-bit integers with nearly ideal avalanche (bias 0.108): the two-round xorshift-multiply with the
/// best constants known, by TheIronBorn, from github.com/skeeto/hash-prospector.
template <class U>
[[gnu::always_inline]] inline U mix_bits(U v) {
    v ^= v >> 16;
    v *= U(0x21f0aaadu);
    v ^= v >> 15;
    v *= U(0xd35a2d97u);
    v ^= v >> 15;
    return v;
}

/// `v` folded into the hash `h`; for a fixed h still a bijection of v. The odd offset keeps 0 from being a fixed point.
template <class U>
[[gnu::always_inline]] inline U hash_combine(const U& h, const U& v) {
    return mix_bits(U((h ^ v) + U(0x9e3779b9u)));
}

}  // namespace drt
