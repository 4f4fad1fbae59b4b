#pragma once
// Is a simulated motion physics? A look at nothing but the tracks, by the laws that contacts must obey: the energy
// never rises, and a ball that bounces alone keeps the share of its speed that the restitution says. This catches what
// comparing step lengths cannot: methods that converge, but to the wrong motion (Bullet's default settings do).

#include <limits>

#include "drt/dynamics/path.h"

namespace drt {

struct Audit {
    double energy_rise = 0;  ///< largest, of the sum of kinetic and potential energy / (the largest kinetic energy +
                             ///< what lifts the heaviest body by the size of the smallest)
    int bounces = 0;         ///< of balls that were alone with what they hit
    double restitution_error = 0;  ///< largest |speed after / speed before - restitution| among them
    double worst_time = 0;         ///< of the larger of the two, relative to what is allowed
    double fails_from = std::numeric_limits<double>::infinity();  ///< when either first is more than that

    static constexpr double most_energy_rise = 1e-3, most_restitution_error = 0.02;
    bool passes() const { return energy_rise <= most_energy_rise && restitution_error <= most_restitution_error; }
};

/// Until `end`. While pushes act, and in scenes with kinematic bodies, the energy is not looked at.
Audit audit(const RigidScene&, const std::vector<Track>&, double end);

}  // namespace drt
