#pragma once
// Accuracy by control: the motion is computed with ever shorter steps until two halvings in a row change nothing that
// matters and the audit agrees; and once more from a start that differs by next to nothing, which tells how long the
// motion can be foretold at all.

#include "drt/dynamics/audit.h"
#include "drt/dynamics/simulate.h"

namespace drt {

struct Controlled {
    Simulation simulation;
    double step = 0;           ///< seconds, of bodies in contact
    int runs = 0;              ///< of the simulation, the last one's included
    double error = 0;          ///< largest distance to the run before, up to `trusted_until`
    double trusted_until = 0;  ///< the end, or when runs that should agree first differ by more than the tolerance
    bool is_chaotic = false;   ///< it is the start's last digits that limit the trust, not the step
    Audit audit;
};

/// `tolerance`: of positions, in the units of the rigid scene; turns count at the bodies' rims.
Controlled simulate_controlled(const RigidScene&, double begin, double end, double tolerance);

/// How far two motions of a scene are apart, and when they first are by more than `tolerance` (infinite: never).
struct Difference {
    double largest = 0;  ///< until `from`
    double from = 0;
};
Difference compare_motions(const RigidScene&, const std::vector<Track>&, const std::vector<Track>&, double begin,
                           double end, double tolerance);

}  // namespace drt
