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

/// What could not be resolved, and the body that it happened to.
struct Trouble {
    static constexpr double never = std::numeric_limits<double>::infinity();
    double time = never;
    int body = -1;
    double speed = 0;  ///< of the body
};

struct Simulation {
    std::vector<Track> tracks;  ///< by body
    std::vector<Impact> impacts;
    int contact_steps = 0;
    double contact_points = 0;  ///< of all steps together: what they cost
    Trouble given_up;  ///< too many events, of which this body had the last: from then on all bodies stand still
    double deepest_start = 0, deepest_overlap = 0;  ///< that bodies start with; that a step left. They are pushed apart
    Trouble started_in_another, overlapped;         ///< where they are deepest
};

/// From time `begin` to `end`; `step` is the longest step of bodies in contact, seconds.
Simulation simulate(const RigidScene&, double begin, double end, double step);

/// Kinetic, of all dynamic bodies.
double kinetic_energy(const RigidScene&, const std::vector<RigidState>&);

/// Changes a body's motion as a blow at a point does (from its centre, along the world's axes).
void strike(const RigidBody&, RigidState&, const Vec3d& impulse, const Vec3d& at);

}  // namespace drt
