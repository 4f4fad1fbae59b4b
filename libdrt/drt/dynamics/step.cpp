#include "drt/dynamics/step.h"

#include <algorithm>
#include <cmath>

#include "drt/dynamics/hold.h"

namespace drt {

namespace {

// Lengths, in sizes of the smallest moving body.
constexpr double rim_way = 0.01;  // that a corner of a turning body may go in a step
constexpr double nothing = 2e-5;  // length: gaps of this size are what turning bodies make within a step
constexpr double sinking = 1e-4;  // that bodies may go into each other in a step
constexpr double thrown = 0.005;  // that a jump of the velocity may be worth in a step

double reach(const RigidBody& b) { return corner_reach(b.collider); }

// What is uncertain of the way that a body goes in a step whose contacts change its velocity by so much. A body at rest
// on others has the change that takes away its fall, which is none.
double uncertain_way(const RigidBody& b, const RigidState& before, const RigidState& free, const RigidState& after,
                     double seconds) {
    const double jump = length(after.velocity - before.velocity) - length(free.velocity - before.velocity);
    return 0.5 * seconds * (jump + length(after.spin - before.spin) * reach(b));
}

std::vector<RigidState> with_velocities(std::vector<RigidState> places, const std::vector<RigidState>& velocities) {
    for (size_t i = 0; i < places.size(); ++i) {
        places[i].velocity = velocities[i].velocity;
        places[i].spin = velocities[i].spin;
    }
    return places;
}

// The share of the velocity after the step in that of its path. Where contacts set in or end within the step, the mean
// would carry bodies into each other or apart; and bodies that touch must move alike.
std::vector<double> shares_after(const RigidScene& scene, const std::vector<RigidState>& free,
                                 const std::vector<RigidState>& after, std::span<const Contact> contacts,
                                 std::vector<bool>& abrupt, double seconds) {
    const auto moves = [&](int i) { return scene.bodies[size_t(i)].kind == RigidBody::Kind::dynamic; };
    std::vector<double> share(free.size(), 0.5);
    for (size_t i = 0; i < share.size(); ++i)
        if (abrupt[i]) share[i] = 1;
    for (const Contact& c : contacts)
        for (const ContactPoint& p : c.points()) {
            const bool apart = p.gap > nothing || p.approach * seconds < -nothing;
            const bool sets_in = apart && approach_at(c, p, free) * seconds > p.gap;
            const double approach_of_mean = 0.5 * (p.approach + approach_at(c, p, after));
            if (sets_in || approach_of_mean * seconds > std::max(p.gap, 0.0) + sinking)
                share[size_t(c.a)] = share[size_t(c.b)] = 1;
        }
    for (bool spreads = true; spreads;) {
        spreads = false;
        for (const Contact& c : contacts) {
            double &a = share[size_t(c.a)], &b = share[size_t(c.b)];
            if (a == b || !moves(c.a) || !moves(c.b)) continue;
            a = b = 1;
            spreads = true;
        }
    }
    return share;
}

}  // namespace

ContactStep contact_step(const RigidScene& scene, const std::vector<RigidState>& states,
                         std::span<const Contact> touching, const std::vector<RigidState>& free,
                         std::span<Contact> middle, double seconds, const StepLimits& limits) {
    ContactStep out{states, free, std::vector<bool>(states.size(), false), false};
    hold(scene, out.after, middle, seconds);
    std::vector<bool> abrupt(states.size(), false);
    for (size_t i = 0; i < states.size(); ++i) {
        const RigidBody& b = scene.bodies[i];
        if (b.kind != RigidBody::Kind::dynamic) continue;
        out.held[i] = out.after[i].velocity != free[i].velocity || out.after[i].spin != free[i].spin;
        abrupt[i] = out.held[i] && uncertain_way(b, states[i], free[i], out.after[i], seconds) > limits.thrown;
        out.is_too_long = out.is_too_long || abrupt[i];
    }
    const std::vector<double> share = shares_after(scene, with_velocities(states, free),
                                                   with_velocities(states, out.after), touching, abrupt, seconds);
    for (size_t i = 0; i < states.size(); ++i) {
        if (scene.bodies[i].kind != RigidBody::Kind::dynamic) continue;
        RigidState& s = out.during[i];
        s.velocity += (out.after[i].velocity - s.velocity) * share[i];
        s.spin += (out.after[i].spin - s.spin) * share[i];
        if (out.held[i] && length(s.spin) * reach(scene.bodies[i]) * seconds > 2 * limits.rim_way)
            out.is_too_long = true;
    }
    return out;
}

void set_gaps_of_begin(std::span<Contact> contacts, const std::vector<RigidState>& middle, double seconds) {
    for (Contact& c : contacts)
        for (ContactPoint& p : c.points()) {
            p.gap += 0.5 * seconds * approach_at(c, p, middle);
            if (p.gap < nothing) p.gap = 0;
        }
}

StepLimits step_limits(const RigidScene& scene, double longest_step) {
    const double fall = longest_step * std::max(1.0, std::sqrt(length(scene.gravity)));
    return {0.1 * fall, 0.05 * fall};
}

double longest_contact_step(const RigidBody& b, const RigidState& s, const StepLimits& limits) {
    return limits.rim_way / std::max(1e-30, length(s.spin) * reach(b));
}

}  // namespace drt
