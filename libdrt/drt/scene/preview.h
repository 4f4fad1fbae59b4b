#pragma once
// The legacy preview (-p): the scene as the classic ray tracer would show it.

#include "drt/scene/scene_desc.h"

namespace drt {

/// The same scene with every distributed effect off, for a quick look at one sample a pixel:
/// the shutter opens for an instant, cameras are pinholes, reflections and refractions are sharp, the filter is a point
/// and spp is 1. Every light becomes an invisible point at its centre. A light without falloff keeps its colour; a
/// physical one gets the radiant intensity that it has head-on: radiance times area for a rectangle, times pi r^2 for a
/// sphere. (A rectangle's cosine and its dark back are lost: the point shines the same all around.)
SceneDesc without_distributed_effects(SceneDesc);

}  // namespace drt
