#pragma once
// Scenes with physics: their bodies' motion is computed, or found in the cache, before anything is rendered.

#include <optional>

#include "console.h"
#include "drt/scene/scene_desc.h"
#include "options.h"

namespace drt {

/// The scene with keyframes in place of physics; nothing if it has no physics. Warns of frames that the simulation
/// does not reach or cannot tell. Throws Error (usage) when no camera records a frame, (asset) when Bullet is missing.
std::optional<SceneDesc> bake_physics(const RenderArguments&, const SceneDesc&, Console&);

}  // namespace drt
