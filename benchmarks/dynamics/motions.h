#pragma once
// Motions whose truth is known, in the units of the rigid scene: a ball's radius and half a cube's side are 1.

#include <functional>
#include <string>
#include <vector>

#include "drt/dynamics/rigid_body.h"

namespace drt::bench {

/// Of a body's centre, at a time.
using Exact = std::function<Vec3d(size_t body, double time)>;

struct Motion {
    std::string name, variant;
    RigidScene scene;
    double end = 0;                   ///< seconds
    Exact exact;                      ///< empty: there is no closed form
    bool in_flight = false;           ///< all bodies begin so
    int most_steps_a_second = 12288;  ///< what Bullet is asked for: the stacks take long
};

std::vector<Motion> all_motions();

}  // namespace drt::bench
