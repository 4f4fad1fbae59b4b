#pragma once
// Pixel filters, by rejection from the filter's own values.

#include "drt/scene/scene_desc.h"
#include "reference/random.h"

namespace drt::reference {

/// The filter along one axis, unnormalised, with its maximum 1 at x = 0; zero outside the radius.
double filter_value(const Filter&, double x);

class PixelFilter {
public:
    explicit PixelFilter(const Filter&);

    struct Sample {
        Vec2d offset;       ///< pixels from the pixel's centre
        double weight = 1;  ///< averages to 1; negative where the filter is
    };
    Sample sample(Random&) const;

private:
    double sample_axis(Random&, double& weight) const;

    Filter filter_;
    double magnitude_ = 1;  ///< integral of |f| over integral of f, along one axis
};

}  // namespace drt::reference
