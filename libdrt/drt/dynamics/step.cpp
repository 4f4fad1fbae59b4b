#include "drt/dynamics/step.h"

#include <algorithm>
#include <cmath>

#include "drt/dynamics/hold.h"

namespace drt {

namespace {

constexpr double nothing = 1e-6;  // length: gaps of this size are those of bodies that touch

double reach(const RigidBody& b) { return corner_reach(b.collider); }

void accelerate(std::vector<RigidState>& states, const std::vector<Vec3d>& accelerations, double seconds) {
    for (size_t i = 0; i < states.size(); ++i) states[i].velocity += accelerations[i] * seconds;
}

void close_small_gaps(std::span<Contact> contacts) {
    for (Contact& c : contacts)
        for (ContactPoint& p : c.points())
            if (p.gap < nothing) p.gap = 0;
}

// What is uncertain of the way that a body goes in a step whose contacts change its velocity by so much. A body at rest
// on others has the change that takes away its fall, which is none.
double uncertain_way(const RigidBody& b, const RigidState& before, const RigidState& free, const RigidState& during,
                     double seconds) {
    const double jump = length(during.velocity - before.velocity) - length(free.velocity - before.velocity);
    return seconds * (jump + length(during.spin - before.spin) * reach(b));
}

}  // namespace

StepLimits step_limits(const RigidScene& scene, double longest_step) {
    const double fall = longest_step * std::max(1.0, std::sqrt(length(scene.gravity)));
    return {0.1 * fall, 0.05 * fall};
}

double longest_contact_step(const RigidBody& b, const RigidState& s, const StepLimits& limits) {
    return limits.rim_way / std::max(1e-30, length(s.spin) * reach(b));
}

void set_gaps_of_begin(std::span<Contact> contacts, const std::vector<RigidState>& middle, double seconds) {
    for (Contact& c : contacts)
        for (ContactPoint& p : c.points()) p.gap += 0.5 * seconds * approach_at(c, p, middle);
}

bool begin_step(const RigidScene& scene, std::vector<RigidState>& states, const std::vector<Vec3d>& accelerations,
                std::span<Contact> contacts, double seconds, const StepLimits& limits) {
    const std::vector<RigidState> before = states;
    accelerate(states, accelerations, 0.5 * seconds);
    const std::vector<RigidState> free = states;
    close_small_gaps(contacts);
    hold(scene, states, contacts, 0.5 * seconds, seconds);
    for (size_t i = 0; i < states.size(); ++i) {
        const RigidBody& b = scene.bodies[i];
        if (states[i].velocity == free[i].velocity && states[i].spin == free[i].spin) continue;
        if (uncertain_way(b, before[i], free[i], states[i], seconds) > limits.thrown) return false;
        if (length(states[i].spin) * reach(b) * seconds > 2 * limits.rim_way) return false;
    }
    return true;
}

void end_step(const RigidScene& scene, std::vector<RigidState>& states, const std::vector<Vec3d>& accelerations,
              std::span<Contact> contacts, double seconds) {
    accelerate(states, accelerations, 0.5 * seconds);
    close_small_gaps(contacts);
    hold(scene, states, contacts, 0.5 * seconds, seconds);
}

}  // namespace drt
