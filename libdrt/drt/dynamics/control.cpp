#include "drt/dynamics/control.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drt/dynamics/nearest.h"

namespace drt {

namespace {

constexpr double samples_per_second = 240;  // where motions are compared
constexpr int most_samples = 100000;
constexpr double longest_step = 1.0 / 96;
constexpr int most_halvings = 6;
constexpr int most_steps = 100000;     // of a run: what takes more is not halved again
constexpr double perturbation = 1e-9;  // of the smallest body's size: what a file's digits say of a place

// Seconds in which a body falls by a good part of its size.
double first_step(const RigidScene& scene) {
    const double g = length(scene.gravity);
    return g > 0 ? std::min(longest_step, 0.25 / std::sqrt(g)) : longest_step;
}

RigidScene perturbed(const RigidScene& scene) {
    RigidScene out = scene;
    double k = 0;
    for (RigidBody& b : out.bodies)
        if (b.kind == RigidBody::Kind::dynamic) {
            k += 1;  // another direction for each
            b.start.position += Vec3d{std::sin(2 * k), 0.1 * std::sin(5 * k), std::cos(3 * k)} * perturbation;
        }
    return out;
}

bool steps_are_few(const Simulation& s) { return s.contact_steps > 0 && s.contact_steps <= most_steps; }

double apart(const RigidBody& body, const RigidState& a, const RigidState& b) {
    const Quatd q = b.orientation * conjugate(a.orientation);
    const double sine_of_half = length(Vec3d{q.x, q.y, q.z});
    return length(b.position - a.position) + 2 * std::min(1.0, sine_of_half) * bounding_radius(body.collider);
}

}  // namespace

Difference compare_motions(const RigidScene& scene, const std::vector<Track>& a, const std::vector<Track>& b,
                           double begin, double end, double tolerance) {
    Difference out{0, std::numeric_limits<double>::infinity()};
    const int samples = std::clamp(int((end - begin) * samples_per_second), 1, most_samples);
    for (int k = 0; k <= samples; ++k) {
        const double t = begin + (end - begin) * k / samples;
        double largest = 0;
        for (size_t i = 0; i < scene.bodies.size(); ++i)
            if (scene.bodies[i].kind == RigidBody::Kind::dynamic)
                largest = std::max(largest, apart(scene.bodies[i], state_at(scene.bodies[i], a[i], t),
                                                  state_at(scene.bodies[i], b[i], t)));
        if (!(largest <= tolerance)) return {out.largest, t};
        out.largest = std::max(out.largest, largest);
    }
    return out;
}

Controlled simulate_controlled(const RigidScene& scene, double begin, double end, double tolerance) {
    Controlled out;
    out.step = first_step(scene);
    out.simulation = simulate(scene, begin, end, out.step);
    out.runs = 1;
    out.audit = audit(scene, out.simulation.tracks, end);
    out.trusted_until = end;
    if (out.simulation.impacts.size() <= 1 && out.simulation.contact_steps == 0)
        return out;  // nothing touches anything

    const auto compare = [&](const Simulation& other, double until) {
        return compare_motions(scene, out.simulation.tracks, other.tracks, begin, until, tolerance);
    };
    const Difference twin = compare(simulate(perturbed(scene), begin, end, out.step), end);
    ++out.runs;
    double horizon = std::min(end, twin.from);
    out.is_chaotic = twin.from < end;
    int agreements = 0;
    Simulation coarser;
    for (int k = 0; k < most_halvings && agreements < 2 && steps_are_few(out.simulation); ++k) {
        coarser = std::exchange(out.simulation, simulate(scene, begin, end, out.step / 2));
        ++out.runs;
        out.step /= 2;
        const Difference d = compare(coarser, horizon);
        out.error = d.largest;
        out.audit = audit(scene, out.simulation.tracks, end);
        out.trusted_until = std::min(horizon, d.from);
        const bool agrees = d.from >= horizon && out.audit.passes();
        agreements = agrees ? agreements + 1 : 0;
    }
    if (coarser.tracks.empty()) out.trusted_until = horizon;
    if (out.is_chaotic && !coarser.tracks.empty()) {  // the first horizon was that of the longest steps
        const Difference steps = compare(coarser, end);
        const double start = compare(simulate(perturbed(scene), begin, end, out.step), end).from;
        ++out.runs;
        out.error = steps.largest;
        out.trusted_until = std::min({end, steps.from, start});
        out.is_chaotic = start <= steps.from && start < end;
    }
    out.trusted_until = std::min(out.trusted_until, out.simulation.given_up_at);
    return out;
}

}  // namespace drt
