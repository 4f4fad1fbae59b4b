#pragma once
// A picture that knows how sure it is: the common currency of picture comparisons.

#include <vector>

#include "drt/base/color.h"

namespace drt {

using Rgb = Color3<double>;

/// Row-major, rows from the top. `variance` is an unbiased estimate of the variance of each `mean`, and may be as
/// rough as one degree of freedom a pixel: comparisons pool it over blocks. Pixels are independent of each other.
struct PictureEstimate {
    int width = 0, height = 0;
    std::vector<Rgb> mean, variance;
    double freedom = 1;  ///< degrees of freedom that each variance rests on

    PictureEstimate() = default;
    PictureEstimate(int w, int h) : width(w), height(h), mean(size_t(w) * size_t(h)), variance(size_t(w) * size_t(h)) {}
    size_t index(int x, int y) const { return size_t(y) * size_t(width) + size_t(x); }
};

}  // namespace drt
