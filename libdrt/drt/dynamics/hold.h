#pragma once
// The impulses between bodies in lasting contact: a linear complementarity problem with Coulomb's friction, solved to
// rounding by sweeps that find which contacts hold, slide or part and a direct solution for those that hold (projected
// Gauss-Seidel with subspace minimisation, Silcowitz, Niebe and Erleben 2010). Bullet's solver only sweeps: with 10
// boxes 20000 sweeps leave an error of 1e-4 of the speed, and with a heavy body on light ones it fails
// (docs/dynamics.md).

#include <span>

#include "drt/dynamics/contact_world.h"

namespace drt {

/// Changes the velocities of dynamic bodies by what contacts do to them while forces act for `seconds`, such that no
/// pair overlaps by more than it does now if the bodies then go on for `way` seconds; with 0 seconds: that none comes
/// closer. There is no restitution. The contacts' points must be those of the states' places; their forces are where
/// the solution begins, and become what it found. Returns the largest error that is left, length / s.
double hold(const RigidScene&, std::vector<RigidState>&, std::span<Contact> contacts, double seconds, double way);

}  // namespace drt
