#pragma once
// Small faults planted in a scene, for tests of what comparisons of pictures see.

#include "drt/scene/scene_desc.h"

namespace drt {

void brighten_lights(SceneDesc&, float factor);

/// The spread of every glossy lobe, reflected and refracted.
void widen_lobes(SceneDesc&, double factor);

/// Turns every camera such that the picture's middle moves by this many pixels to the left: what a filter shows whose
/// middle is that far to the right of the pixel's. For cameras that stand still.
void shift_filter(SceneDesc&, double pixels);

}  // namespace drt
