#pragma once
// The picture of a ball whose motion is known in closed form, as the average over the shutter's time.

#include <functional>

#include "drt/scene/scene_desc.h"
#include "reference/motion.h"
#include "support/estimate.h"

namespace drt {

/// Where the ball is, and how far it has turned from its described pose, at a scene time.
using Course = std::function<reference::Pose(double time)>;

/// Frame 0 of a scene whose first body is a sphere, at the scene's own size; the body's own motion is not looked at.
/// Each sample shows a sphere that stands still where the course says at a random instant of the exposure (the scene
/// otherwise as described), so no keyframe and no interpolation is involved.
PictureEstimate time_average(const SceneDesc&, const Course&, int spp, std::uint64_t seed);

}  // namespace drt
