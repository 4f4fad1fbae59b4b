#pragma once
// The moment of a sample within the exposure. The shutter opens and closes linearly, each over half of the switch
// ratio, so its weight over the exposure [0, 1] is a trapezoid: (t - tB) / tS while it opens (docs: model, section 3).

#include "drt/base/simd.h"

namespace drt {

/// Time in [0, 1] by the inverse CDF of the trapezoid: monotone in u, so a stratified u gives a stratified time.
/// `switch_ratio` in [0, 1]: 0 is uniform, 1 a triangle.
template <class T>
[[gnu::always_inline]] inline T shutter_time(const T& u, const T& switch_ratio) {
    using std::sqrt;
    const T ramp = T(0.5f) * switch_ratio;  // length of opening, and of closing
    const T area = T(1) - ramp;             // under a trapezoid of height 1
    const T mass = u * area;                // of the shutter's weight before the time sought
    const T mass_after = (T(1) - u) * area;
    const T half = T(0.5f) * ramp;
    const T opening = sqrt(T(2) * ramp * mass);
    const T closing = T(1) - sqrt(T(2) * ramp * mass_after);
    return select(mass < half, opening, select(mass_after < half, closing, T(mass + half)));
}

/// The density of shutter_time at t in [0, 1].
template <class T>
[[gnu::always_inline]] inline T shutter_pdf(const T& t, const T& switch_ratio) {
    const T ramp = T(0.5f) * switch_ratio;
    const T edge = min(t, T(T(1) - t));
    return select(edge < ramp, T(edge / ramp), T(1)) / (T(1) - ramp);
}

}  // namespace drt
