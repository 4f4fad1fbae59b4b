#pragma once
// Overlaps, of the start or of what turning bodies gain on each other within a step, are pushed apart without speed.

#include "drt/dynamics/contact_world.h"

namespace drt {

/// Moves dynamic bodies along the contacts' normals, the light ones more, until none overlaps. Returns the deepest
/// overlap there was, and the bodies that were moved.
struct PushedApart {
    double deepest = 0;
    std::vector<int> moved;
};
PushedApart push_apart(const RigidScene&, const std::vector<Contact>&, std::vector<RigidState>&);

}  // namespace drt
