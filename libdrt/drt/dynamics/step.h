#pragma once
// A step of bodies that hold each other: what they move at, and what they move at after it.

#include <span>
#include <vector>

#include "drt/dynamics/contact_world.h"

namespace drt {

struct ContactStep {
    std::vector<RigidState> during;  ///< velocity and spin are constant during the step; places are its begin's
    std::vector<RigidState> after;   ///< velocity and spin after it
    std::vector<bool> held;          ///< does it feel a contact
    bool is_too_long = false;        ///< bodies turn too far in it, or are thrown about within it
};

/// How far things may go in a step, lengths in sizes of the smallest moving body: they shrink with the step asked for,
/// so that halving it halves the steps.
struct StepLimits {
    double rim_way = 0.01;  ///< that a corner of a turning body may go
    double thrown = 0.005;  ///< that a jump of the velocity may be worth
};
StepLimits step_limits(const RigidScene&, double longest_step);

/// `touching`: the contacts at the step's begin, where `states` are. `free`: places of its middle, velocities after it
/// if nothing touched. `middle`: the same pairs' contacts there, with forces as hold() wants them. Bodies move at the
/// mean of their velocities before and after: with the contacts of the middle that is second order in the step. Where
/// contacts set in or end within it, they move at the velocity after it.
ContactStep contact_step(const RigidScene&, const std::vector<RigidState>& states, std::span<const Contact> touching,
                         const std::vector<RigidState>& free, std::span<Contact> middle, double seconds,
                         const StepLimits&);

/// Gaps of the middle's contacts become what they were at the step's begin, as far as the velocities tell that:
/// `middle` has its places, and the begin's velocities.
void set_gaps_of_begin(std::span<Contact>, const std::vector<RigidState>& middle, double seconds);

/// That turning corners allow, before anything is known of the forces.
double longest_contact_step(const RigidBody&, const RigidState&, const StepLimits&);

}  // namespace drt
