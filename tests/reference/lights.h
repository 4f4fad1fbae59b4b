#pragma once
// Light as it arrives at a point.

#include <optional>

#include "drt/scene/scene_desc.h"
#include "reference/random.h"
#include "support/estimate.h"

namespace drt::reference {

struct LightSample {
    Vec3d point;    ///< of the light: visible or not decides whether the sample counts
    Rgb intensity;  ///< I_l of the Phong formula (with inverse_square: irradiance facing the light over pi), over
                    ///< the density of the sample
};

/// One random point of the light as seen from `from`; nothing where the light is black.
std::optional<LightSample> sample_light(const Light&, const Vec3d& from, Random&);

/// Radiance that a visible light sends towards a ray that travels along `direction`.
Rgb emitted(const Light&, const Vec3d& direction);

}  // namespace drt::reference
