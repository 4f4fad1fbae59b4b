#pragma once
// Tracks become motion keyframes: where motion changes abruptly there is a key, and as few others as keep what is
// interpolated linearly between them within tolerances.

#include "drt/dynamics/path.h"
#include "drt/scene/scene_desc.h"

namespace drt {

struct KeyTolerance {
    double position = 1e-3;  ///< in the units of the rigid scene
    double angle = 1e-3;     ///< radians
};

/// Keys from time `begin` to `end`; a body that does not move has one. Positions are in the units of the rigid scene.
std::vector<MotionKey> keys_of(const RigidBody&, const Track&, double begin, double end, const KeyTolerance&);

}  // namespace drt
