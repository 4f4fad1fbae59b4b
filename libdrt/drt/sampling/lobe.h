#pragma once
// The glossy lobe of the model: a deviation theta from the ideal direction with density proportional to
// exp(-theta^2 / (2 sigma^2)) cos(theta) on [0, pi/2). It is a density over the angle, not over solid angle (no
// sin(theta)): the limit of the thesis' weighted average, sampled directly, so that every sample weighs the same.

#include <vector>

#include "drt/base/constants.h"
#include "drt/base/frame.h"
#include "drt/base/math.h"
#include "drt/sampling/inverse_cdf.h"

namespace drt {

/// The lobes of a scene's materials, packed so that every lane may use another one.
struct LobeTables {
    InverseCdfs inverse;
    std::vector<double> sigma;          ///< radians
    std::vector<double> integral;       ///< of exp(-theta^2 / (2 sigma^2)) cos(theta) over [0, pi/2)
    std::vector<float> falloff, scale;  ///< -1 / (2 sigma^2) and 1 / (2 pi integral), for lobe_density
};

/// The number of the lobe of this sigma (radians, >= 0; 0 = perfectly sharp), added if it is new. Costs about 0.2 ms
/// and 8 kB for each different sigma.
int add_lobe(LobeTables&, double sigma);

/// theta in [0, pi/2) for u in [0, 1), monotone. A float u should be a multiple of 2^-24, as the sampler's are: then
/// 1 - u is exact, and the error, as a relative error of the CDF on either side, is below 1e-6.
template <class T>
[[gnu::always_inline]] inline T lobe_theta(const LobeTables& tables, const Rebind<T, std::int32_t>& lobe, const T& u) {
    return inverse_cdf(tables.inverse, lobe, T(T(1) - u));
}

/// The density of lobe_theta, per radian.
double lobe_pdf_theta(const LobeTables&, int lobe, double theta);
/// The same per steradian: lobe_pdf_theta / (2 pi sin(theta)); infinite at theta = 0.
double lobe_pdf(const LobeTables&, int lobe, double theta);

/// lobe_pdf for lanes, each with a lobe of its own, from the squared distance of two unit vectors, the direction and
/// the lobe's axis, which keeps its digits near the axis. There, where the density is infinite, a very large number.
template <class T>
[[gnu::always_inline]] inline T lobe_density(const LobeTables& tables, const Rebind<T, std::int32_t>& lobe,
                                             const T& chord2) {
    using std::sqrt;
    const T theta = T(2) * fast_asin(T(sqrt(chord2) * T(0.5f)));
    const T sine = sqrt(max(T(chord2 * (T(1) - chord2 * T(0.25f))), T(0)));
    const T cosine = max(T(T(1) - chord2 * T(0.5f)), T(0));
    const T scale = gather_coherent<T>(tables.scale.data(), lobe);
    const T falloff = gather_coherent<T>(tables.falloff.data(), lobe);
    return scale * cosine * fast_exp(T(falloff * theta * theta)) / max(sine, T(1e-15f));
}

/// The unit direction at angle theta from frame.z, azimuth u in turns: normalize(z + (cos x + sin y) tan(theta)).
template <class T>
[[gnu::always_inline]] inline Vec3<T> lobe_direction(const Frame<T>& frame, const T& theta, const T& azimuth_turns) {
    const auto [sin_azimuth, cos_azimuth] = sincos_2pi(azimuth_turns);
    const auto [s, c] = sincos_2pi(T(theta * T(1 / (2 * pi<ScalarOf<T>>))));
    return frame.to_world({cos_azimuth * s, sin_azimuth * s, c});
}

}  // namespace drt
