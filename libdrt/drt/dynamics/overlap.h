#pragma once
// Overlaps, of the start or of what turning bodies gain on each other within a step, are pushed apart without speed.

#include "drt/dynamics/contact_world.h"

namespace drt {

/// Moves dynamic bodies by as little as can be, counted by their masses, such that none of the contacts' points
/// overlap; they may turn as well if `turning`. Returns the bodies that were moved, and how deep the
/// deepest was in another.
struct PushedApart {
    double deepest = 0;
    int deepest_body = -1;
    std::vector<int> moved;
};
PushedApart push_apart(const RigidScene&, const std::vector<Contact>&, std::vector<RigidState>&, bool turning);

}  // namespace drt
