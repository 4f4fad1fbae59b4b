#pragma once
// Steps of bodies that hold each other. Forces act for half a step, the bodies go for a step at the velocities that are
// theirs then, and forces act for the other half (leapfrog). What contacts allow is asked where it matters: for the
// way, in the middle of it, so that bodies that tip and roll on each other stay in touch to third order; for the
// velocity after it, at its end (as RATTLE does for joints, Andersen 1983). A sliding body's way is exact.

#include <span>
#include <vector>

#include "drt/dynamics/contact_world.h"

namespace drt {

/// How far things may go in a step, lengths in sizes of the smallest moving body: they shrink with the step asked for,
/// so that halving it halves the steps.
struct StepLimits {
    double rim_way = 0.01;  ///< that a corner of a turning body may go
    double thrown = 0.005;  ///< that a jump of the velocity may be worth
};
StepLimits step_limits(const RigidScene&, double longest_step);

/// That turning corners allow, before anything is known of the forces.
double longest_contact_step(const RigidBody&, const RigidState&, const StepLimits&);

/// Gaps of contacts of the middle become what they were at the step's begin, as far as the velocities tell that:
/// `middle` has its places, and the begin's velocities.
void set_gaps_of_begin(std::span<Contact>, const std::vector<RigidState>& middle, double seconds);

/// The first half: `states` are the begin's velocities at the places of the middle, `contacts` those of the middle with
/// the gaps of the begin. The velocities become those of the way. False: the step is too long, for bodies turn too far
/// in it or are thrown about within it.
bool begin_step(const RigidScene&, std::vector<RigidState>&, const std::vector<Vec3d>& accelerations,
                std::span<Contact>, double seconds, const StepLimits&);

/// The second half, where the bodies are now.
void end_step(const RigidScene&, std::vector<RigidState>&, const std::vector<Vec3d>& accelerations, std::span<Contact>,
              double seconds);

}  // namespace drt
