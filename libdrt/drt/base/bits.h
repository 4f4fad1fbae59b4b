#pragma once
// Bits of 32-bit integers and of floats, for scalars and lanes alike.

#include <array>
#include <bit>

#include "drt/base/simd.h"

namespace drt {

/// The bits of `v` as another type of the same size: lanes to lanes, scalar to scalar.
template <class To, class From>
[[gnu::always_inline]] inline To bits_as(const From& v) {
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
[[gnu::always_inline]] inline U reverse_bits(U v) {
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

/// table[v & 15] in every lane. U holds std::uint32_t.
template <class U>
[[gnu::always_inline]] inline U lookup_nibble(const std::array<std::uint32_t, 16>& table, const U& v) {
#if defined(__AVX512F__)
    if constexpr (is_lane<U> && sizeof(U) == 64)
        return U(_mm512_permutexvar_epi32(static_cast<__m512i>(v), _mm512_loadu_si512(table.data())));
#endif
#if defined(__AVX2__)
    if constexpr (is_lane<U> && sizeof(U) == 32 && width_of<U> == 8) {
        const __m256i index = static_cast<__m256i>(v);
        const auto half = [&](size_t from) {
            return _mm256_permutevar8x32_epi32(
                _mm256_loadu_si256(reinterpret_cast<const __m256i*>(table.data() + from)), index);
        };
        // bit 3 chooses the half of the table: moved to the sign, where the blend looks
        const __m256 upper = _mm256_castsi256_ps(_mm256_slli_epi32(index, 28));
        return U(
            _mm256_castps_si256(_mm256_blendv_ps(_mm256_castsi256_ps(half(0)), _mm256_castsi256_ps(half(8)), upper)));
    }
#endif
    if constexpr (!is_lane<U>)
        return table[v & 15u];
    else
        return U([&](auto i) { return table[v[i] & 15u]; });
}

}  // namespace drt
