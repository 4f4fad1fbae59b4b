#pragma once
// A quantile function in a few instructions: one polynomial for each octave of the tail's mass.
//
// A density on [0, length] is sampled through v in [0, 1], the fraction of the mass *beyond* x: x(1) = 0,
// x(0) = length. Gaussian tails and densities that end in zero make x(v) singular at v = 0, but smooth over any octave:
// a polynomial of degree 7 follows it to some 1e-6 of the length. Sixteen octaves fit in a register of 16 lanes, so a
// coefficient is looked up by a shuffle; tables in memory (inverse_cdf.h) take four times as long.

#include <array>
#include <cstdint>

#include "drt/base/bits.h"
#include "drt/base/math.h"
#include "drt/sampling/tail_mass.h"

namespace drt {

struct OctaveQuantiles {
    static constexpr int octaves = 16;  ///< number i is v in [2^-(i+1), 2^-i); the last one reaches down to 0
    static constexpr int degree = 7;
    /// The bits of the coefficient of t^k, by octave; t = 2^(i + 2) v - 3 runs from -1 to 1.
    std::array<std::array<std::uint32_t, octaves>, degree + 1> coefficients{};
    float length = 0;
};

/// Error: below 2e-6 of the length for v >= 2^-15, a few percent of what is left of it beyond.
OctaveQuantiles octave_quantiles(const TailMass&);

/// x in [0, length] where a fraction v of the mass lies beyond x.
template <class F>
[[gnu::always_inline]] inline F quantile(const OctaveQuantiles& q, const F& v) {
    using I = Rebind<F, std::int32_t>;
    using U = Rebind<F, std::uint32_t>;
    const I octave = max(min(I(126) - (bits_as<I>(v) >> 23), I(OctaveQuantiles::octaves - 1)), I(0));
    const F scale = bits_as<F>(I((octave + I(129)) << 23));  // 2^(octave + 2)
    const F t = mul_add(v, scale, F(-3));
    const U index = bits_as<U>(octave);
    const auto coefficient = [&](int k) { return bits_as<F>(lookup_nibble(q.coefficients[size_t(k)], index)); };
    F x = coefficient(OctaveQuantiles::degree);
    for (int k = OctaveQuantiles::degree; k-- > 0;) x = mul_add(x, t, coefficient(k));
    return min(max(x, F(0)), F(q.length));
}

}  // namespace drt
