#pragma once
// From a point on a textured body to texture coordinates, the footprint of the ray's cone in them, and the colour.
// Lanes are handled body by body: all lanes of a packet mostly see the same one.

#include "drt/plan/world.h"
#include "drt/stages/ray_batch.h"

namespace drt {

/// The diffuse colour of the lanes whose body wears a texture; `albedo` in the others.
template <class Real>
Color3<typename Pack<Real>::F> texture_color(const World<Real>& w, const RayBatch<Real>& batch, int i,
                                             const typename Pack<Real>::I& material,
                                             const Color3<typename Pack<Real>::F>& albedo);

}  // namespace drt
