#pragma once
// Unknown impulses between bodies, one each row, and what each does to the bodies' velocities. Solved for all at once
// (complementarity.h), group by group of bodies that are connected.

#include <vector>

#include "drt/dynamics/rigid_body.h"

namespace drt {

struct Row {
    int a = 0, b = 0;
    Vec3d linear;          ///< on a, of a unit impulse; the opposite on b
    Vec3d turn_a, turn_b;  ///< torque on a, and on b
    double offset = 0;     ///< speed of approach from which it acts
    int normal = -1;       ///< friction: the row of the normal impulse that limits it ...
    double limit = 0;      ///< ... times this
    double impulse = 0;    ///< a guess, then the solution
};

/// That pushes along `direction` at points from the centres of a and b.
Row push_along(int a, int b, const Vec3d& direction, const Vec3d& from_a, const Vec3d& from_b);

/// Changes the velocities of dynamic bodies as the impulses do that keep every row's bodies from approaching faster
/// than its offset. Returns the largest error that is left, length / s.
double solve_rows(const RigidScene&, std::vector<Row>&, std::vector<RigidState>&);

}  // namespace drt
