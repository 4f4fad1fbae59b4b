#include "drt/sampling/octave_quantiles.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "drt/base/constants.h"

namespace drt {

namespace {

constexpr size_t nodes = OctaveQuantiles::degree + 1;
using Coefficients = std::array<double, nodes>;

// The polynomial through (t_i, x_i): Newton's divided differences, multiplied out from the innermost bracket.
Coefficients interpolate(const Coefficients& t, Coefficients x) {
    for (size_t order = 1; order < nodes; ++order)
        for (size_t i = nodes; i-- > order;) x[i] = (x[i] - x[i - 1]) / (t[i] - t[i - order]);
    Coefficients p{};
    for (size_t i = nodes; i-- > 0;) {
        for (size_t k = nodes; k-- > 0;) p[k] = (k > 0 ? p[k - 1] : 0) - t[i] * p[k];
        p[0] += x[i];
    }
    return p;
}

// Chebyshev's nodes keep the error even over the octave. Below 2^-24 lies no sample but v = 0.
Coefficients fit(const TailMass& tail, int octave) {
    const double low = octave + 1 < OctaveQuantiles::octaves ? -1 : -3;
    Coefficients t{}, x{};
    for (size_t i = 0; i < nodes; ++i) {
        const double cosine = std::cos(pi<double> * (double(i) + 0.5) / double(nodes));
        t[i] = 0.5 * ((1 - low) * cosine + 1 + low);
        const double v = std::max(std::ldexp(t[i] + 3, -octave - 2), 0x1p-24);
        x[i] = quantile(tail, v * tail.total());
    }
    return interpolate(t, x);
}

}  // namespace

OctaveQuantiles octave_quantiles(const TailMass& tail) {
    OctaveQuantiles q;
    q.length = float(tail.length);
    for (int octave = 0; octave < OctaveQuantiles::octaves; ++octave) {
        const Coefficients c = fit(tail, octave);
        for (size_t k = 0; k < nodes; ++k)
            q.coefficients[k][size_t(octave)] = std::bit_cast<std::uint32_t>(float(c[k]));
    }
    return q;
}

}  // namespace drt
