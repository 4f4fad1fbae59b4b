#pragma once
// Rigid bodies from contact to contact. Free flight is exact; impacts are found to rounding (impact_time.h) and
// resolved in no time; only while bodies rest, roll or slide on each other does the simulation take steps, and only
// there does it depend on them. Why not Bullet's own stepping: docs/dynamics.md.

#include <limits>

#include "drt/dynamics/path.h"

namespace drt {

struct Impact {
    double time = 0;
    double energy_before = 0, energy_after = 0;  ///< kinetic, of all bodies
};

struct Simulation {
    static constexpr double never_given_up = std::numeric_limits<double>::infinity();
    std::vector<Track> tracks;  ///< by body
    std::vector<Impact> impacts;
    int contact_steps = 0;
    double given_up_at = never_given_up;  ///< when there were too many events; from then on all bodies stand still
    double deepest_overlap = 0;           ///< that a step left and was pushed apart
};

/// From time `begin` to `end`; `step` is the longest step of bodies in contact, seconds.
Simulation simulate(const RigidScene&, double begin, double end, double step);

/// Kinetic, of all dynamic bodies.
double kinetic_energy(const RigidScene&, const std::vector<RigidState>&);

/// Changes a body's motion as a blow at a point does (from its centre, along the world's axes).
void strike(const RigidBody&, RigidState&, const Vec3d& impulse, const Vec3d& at);

}  // namespace drt
