#pragma once
// What drt does not use: Bullet's own time stepping, to measure against.

#include <span>
#include <vector>

#include "drt/dynamics/rigid_body.h"

namespace drt::bench {

struct Settings {
    /// Those Bullet comes with; or the best known for bounces: no speculative contacts and positions that never change
    /// velocities, both only where something bounces, no sleep, more sweeps, and restitution down to slow approaches.
    bool tuned = false;
    /// Tuned, and all bodies begin in flight: half a step's gravity is taken back, which makes Bullet's parabolas
    /// exact.
    bool in_flight = false;
};

/// Positions of all bodies at the times, which must be multiples of the step and ascend. Spheres, boxes, planes.
std::vector<std::vector<Vec3d>> bullet_positions(const RigidScene&, std::span<const double> times, double step,
                                                 const Settings&);

}  // namespace drt::bench
