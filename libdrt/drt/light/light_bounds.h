#pragma once
// Where lights are, which way they shine and how strongly: what is known of a set of them without looking at each.
// Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", 2018.

#include "drt/light/light_table.h"

namespace drt {

struct LightBounds {
    Vec3d lower, upper;
    /// Every normal of an emitting surface is within the angle `spread` of `axis`, and light leaves within pi / 2 of
    /// the normal. From a spread of pi / 2 on, light leaves in all directions.
    Vec3d axis{0, 0, 1};
    double spread = pi<double>;
    double strength = 0;  ///< summed: W / sr
};

LightBounds bounds_of(const PointLightData<double>&);
LightBounds bounds_of(const RectLightData<double>&);
LightBounds bounds_of(const SphereLightData<double>&);

/// Of several sets together.
LightBounds unite(const LightBounds* first, int count);

}  // namespace drt
