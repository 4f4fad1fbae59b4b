#pragma once
// The textbook renderer that the pipeline is measured against: one ray at a time, rtcIntersect1 and rtcOccluded1
// against SPHERE_POINT, scalar Phong shading. Same camera, same sample points, same lights. Direct light only.

#include "bare_scene.h"

namespace drt {

/// Renders `spp` samples of every pixel on one thread; returns the mean of all samples.
Color render_one_ray_at_a_time(const SceneDesc&, const BareBodies&, const BareScene&, int spp);

}  // namespace drt
