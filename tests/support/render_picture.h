#pragma once
// drt's own picture of a scene, in the form that comparisons want.

#include "drt/render/render.h"
#include "support/estimate.h"

namespace drt {

/// Compiles the scene and renders it at its own size. Throws what compile() throws.
RenderResult render_scene(const SceneDesc&, const PlanOptions&, const RenderOptions&);

/// The same as a picture that knows how sure it is: the mean over several seeds, each of `spp` samples (an even number)
/// in two replicates. Two alone would often agree by chance where a pixel's samples can give but a few values: one seed
/// is for comparisons that know the least variance otherwise (CompareOptions).
PictureEstimate estimate_scene(const SceneDesc&, const PlanOptions&, int spp, int seeds = 4);

/// The very same samples, bit for bit.
bool same_bits(const Film&, const Film&);

/// The largest absolute difference between two images of one size, over all channels; NaN differs from everything.
double largest_difference(const Image&, const Image&);

}  // namespace drt
