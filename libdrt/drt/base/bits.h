#pragma once
// Bits of 32-bit integers and of floats, for scalars and lanes alike.

#include <array>
#include <bit>

#include "drt/base/simd.h"

namespace drt {

/// The bits of `v` as another type of the same size: lanes to lanes, scalar to scalar.
template <class To, class From>
To bits_as(const From& v) {
    static_assert(width_of<To> == width_of<From> && sizeof(ScalarOf<To>) == sizeof(ScalarOf<From>));
    if constexpr (std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>) {
        return std::bit_cast<To>(v);
    } else {  // lanes wider than the machine's are tuples that cannot be cast as a whole
        std::array<ScalarOf<From>, size_t(width_of<From>)> memory;
        store(v, memory.data());
        const auto cast = std::bit_cast<std::array<ScalarOf<To>, size_t(width_of<To>)>>(memory);
        return load<To>(cast.data());
    }
}

/// Bit 0 becomes bit 31 and so on. U holds std::uint32_t.
template <class U>
U reverse_bits(U v) {
    static_assert(std::is_same_v<ScalarOf<U>, std::uint32_t>);
#if defined(__GFNI__) && defined(__AVX512BW__)
    if constexpr (is_lane<U> && sizeof(U) == 64) {
        // One affine map over GF(2) reverses the bits of each byte, one shuffle the bytes of each word.
        const __m512i matrix = _mm512_set1_epi64(0x8040201008040201LL);
        const __m512i bytes = _mm512_set4_epi32(0x0c0d0e0f, 0x08090a0b, 0x04050607, 0x00010203);
        return U(_mm512_shuffle_epi8(_mm512_gf2p8affine_epi64_epi8(static_cast<__m512i>(v), matrix, 0), bytes));
    }
#endif
    v = ((v >> 1) & U(0x55555555u)) | ((v & U(0x55555555u)) << 1);
    v = ((v >> 2) & U(0x33333333u)) | ((v & U(0x33333333u)) << 2);
    v = ((v >> 4) & U(0x0f0f0f0fu)) | ((v & U(0x0f0f0f0fu)) << 4);
    v = ((v >> 8) & U(0x00ff00ffu)) | ((v & U(0x00ff00ffu)) << 8);
    return (v >> 16) | (v << 16);
}

}  // namespace drt
