#pragma once
// Tabulated inverse CDFs that stay accurate into the tail.
//
// A density f on [0, length] is sampled through v in (0, 1], the probability *beyond* x: x(1) = 0, x(0) = length.
// Cells of the table are uniform in the mantissa of v within each octave, so they get finer towards v = 0, where
// Gaussian tails and densities that end in zero make x(v) singular, and a cell is found with integer arithmetic on the
// bits of v: no search, no logarithm. Within a cell x is a cubic in v (Hermite: x and dx/dv = -1/f(x) exact at the
// ends), so the map is monotone and a stratified v stays stratified.

#include <functional>
#include <vector>

#include "drt/base/bits.h"

namespace drt {

/// Many tables packed into one array, so that every lane may look into another one.
struct InverseCdfs {
    static constexpr int cells_per_octave = 16;
    static constexpr int octaves = 32;  ///< v >= 2^-32
    static constexpr int cells = cells_per_octave * octaves + 1;
    std::vector<float> coefficients;  ///< [table][cell][4], cubic in the position within the cell, from v downwards
    int size() const { return int(coefficients.size()) / (4 * cells); }
};

/// Appends the table of a density, which need not be normalised, and returns its integral over [0, length]. The table's
/// number is the size before. `density` must be smooth and positive on (0, length) and positive at 0; `length` about as
/// large as the region that holds the mass (at most some 10 standard deviations of a Gaussian). Exact to 1e-13 before
/// tabulation; the tabulated map's error, as a relative error of v, is below 4e-7 + the rounding of x to float.
double append_inverse_cdf(InverseCdfs&, const std::function<double(double)>& density, double length);

/// Appends the table of x = 0.
void append_zero(InverseCdfs&);

/// x where a fraction v of table's density lies beyond x. v in (0, 1]; below 2^-32 as at 2^-32.
template <class T>
[[gnu::always_inline]] inline T inverse_cdf(const InverseCdfs& tables, const Rebind<T, std::int32_t>& table,
                                            const T& v) {
    using F = Rebind<T, float>;
    using I = Rebind<T, std::int32_t>;
    constexpr std::int32_t one = 0x3f800000;  // the bits of 1.0f
    constexpr int cell_bits = 19;             // of the mantissa that lie within a cell: 23 - log2(16)
    const I bits = min(I(bits_as<I>(num_cast<F>(max(v, T(0x1p-32f))))), I(one));
    // The upper end of the cell is the next multiple of the cell's size in bits, at or above v.
    const I cell = (I(one) - bits) >> cell_bits;
    const T upper = num_cast<T>(bits_as<F>(I(I(one) - (cell << cell_bits))));
    const T scale = num_cast<T>(bits_as<F>(I(I(one) + (((cell >> 4) + I(5)) << 23))));  // 1 / the cell's width in v
    const T r = (upper - v) * scale;
    const I at = (table * I(InverseCdfs::cells) + cell) * I(4);
    const std::array<F, 4> c = gather_quads<F>(tables.coefficients.data(), at);
    return num_cast<T>(c[0]) + r * (num_cast<T>(c[1]) + r * (num_cast<T>(c[2]) + r * num_cast<T>(c[3])));
}

}  // namespace drt
