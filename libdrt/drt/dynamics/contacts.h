#pragma once
// Where bodies touch, by the best way there is for their shapes: closed forms for spheres and planes, separating axes
// for flat faces, Bullet for the rest (cylinders with anything but planes and spheres).

#include "drt/dynamics/contact_world.h"

namespace drt {

/// For two bodies with flat faces the distance is a lower bound, and exact where they touch.
Nearest nearest_bodies(const ContactWorld&, const RigidScene&, int a, const RigidState&, int b, const RigidState&);

/// The pairs that are nearer than `reach` (at most farthest_contact), in the order of their bodies,
/// with their points.
std::vector<Contact> find_contacts(ContactWorld&, const RigidScene&, const std::vector<RigidState>&, double reach);

/// Anew from the states' velocities.
void update_approach(std::vector<Contact>&, const std::vector<RigidState>&);

}  // namespace drt
