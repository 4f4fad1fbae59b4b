#pragma once
// Choice of one of n things with given weights: lights by power.
//
// Inverse CDF, not an alias table: it keeps the stratification of u. Probabilities are whole multiples of 2^-24, the
// grid that a float u lives on, and every thing with a positive weight gets at least one unit. So the stated
// probability is exactly the chance of being chosen, however many things there are and however weak one is.

#include <span>
#include <vector>

#include "drt/base/simd.h"

namespace drt {

struct Distribution {
    std::vector<float> cdf;           ///< n + 1 values from 0 to 1, multiples of 2^-24
    std::vector<std::int32_t> guide;  ///< the things at the ends of equal buckets of u, a power of two of them
    int steps = 0;                    ///< bisection steps that finish the search within any bucket
    int size() const { return int(cdf.size()) - 1; }
};

/// Weights are >= 0, finite, at least one positive, at most 2^22 of them; throws Error{internal} otherwise.
Distribution make_distribution(std::span<const double> weights);

template <class T>
struct Choice {
    Rebind<T, std::int32_t> index;
    T probability;  ///< exact and positive
};

/// The thing whose interval of the CDF holds u in [0, 1]; 1, to which a stratified (i + u) / n may round, counts as the
/// largest number below. Monotone in u. T is float or lanes of float.
template <class T>
Choice<T> choose(const Distribution& d, const T& u_closed) {
    using I = Rebind<T, std::int32_t>;
    const T u = min(u_closed, T(0x1.fffffep-1f));
    const I bucket = num_cast<I>(T(u * T(float(d.guide.size() - 1))));
    I lo = gather<I>(d.guide.data(), bucket);
    I hi = gather<I>(d.guide.data(), I(bucket + I(1)));
    // The thing sought is in [lo, hi]: the last one whose cdf is <= u.
    for (int k = 0; k < d.steps; ++k) {
        const I middle = (lo + hi + I(1)) >> 1;
        const auto below = mask_cast<I>(gather<T>(d.cdf.data(), middle) <= u);
        const I next_lo = select(below, middle, lo);
        hi = select(below, hi, max(I(middle - I(1)), lo));
        lo = next_lo;
    }
    return {lo, gather<T>(d.cdf.data(), I(lo + I(1))) - gather<T>(d.cdf.data(), lo)};
}

/// The probability of thing i.
inline float probability(const Distribution& d, int i) { return d.cdf[size_t(i) + 1] - d.cdf[size_t(i)]; }

}  // namespace drt
