#pragma once
// The reference renderer: the simplest code that says what the picture is.
//
// Scalar, double precision, pseudo-random, recursive, every ray against every body. It shares nothing with the
// renderer but the scene description, vectors, colours and the image reader, so that agreement is evidence. Where
// the description leaves a meaning open, the comment beside the code here states the one that both follow.

#include <cstdint>

#include "drt/scene/scene_desc.h"
#include "support/estimate.h"

namespace drt {

using ReferencePicture = PictureEstimate;

/// Frame `frame` of the scene at width x height (which replace the scene's own), `spp` >= 2 independent samples a
/// pixel. Deterministic for one seed whatever the number of threads. Expects a scene that validate() finds no error in;
/// throws Error for unreadable textures and std::invalid_argument where no camera records the frame.
ReferencePicture render_reference(const SceneDesc&, int frame, int width, int height, int spp, std::uint64_t seed);

}  // namespace drt
