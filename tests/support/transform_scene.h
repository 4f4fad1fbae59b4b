#pragma once
// The same scene elsewhere or at another size.

#include "drt/scene/scene_desc.h"

namespace drt {

/// Everything shifted: bodies, keyframes, lights, cameras. Sphere sets cannot be.
SceneDesc translated(SceneDesc, const Vec3d& by);

/// Everything `by` times as large, about the origin, with lights that give the same picture: the intensity of physical
/// point lights grows with the square.
SceneDesc scaled(SceneDesc, double by);

}  // namespace drt
