#pragma once
// Where a body on a known path is.

#include "drt/dynamics/rigid_body.h"

namespace drt {

/// Of the centre, `seconds` after the path's begin.
inline Vec3d position_at(const Path& p, double seconds) {
    return p.from.position + p.from.velocity * seconds + p.acceleration * (0.5 * seconds * seconds);
}
inline Vec3d velocity_at(const Path& p, double seconds) { return p.from.velocity + p.acceleration * seconds; }

RigidState state_at(const RigidBody&, const Path&, double time);
RigidState state_at(const RigidBody&, const Track&, double time);

}  // namespace drt
