#pragma once
// Random scenes that use every field: each value is its default about every third time.

#include <cstdint>

#include "drt/scene/scene_desc.h"

namespace drt {

/// A valid scene.
SceneDesc random_scene(std::uint32_t seed);

}  // namespace drt
