#include "drt/dynamics/control.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <utility>

#include "drt/dynamics/nearest.h"

namespace drt {

namespace {

constexpr double samples_per_second = 240;  // where motions are compared
constexpr int most_samples = 100000;
constexpr double longest_step = 1.0 / 96;
constexpr size_t most_halvings = 6;
constexpr double most_points = 50000;  // of contacts in a run's steps: what takes more is not halved again
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

double apart(const RigidBody& body, const RigidState& a, const RigidState& b) {
    const Quatd q = b.orientation * conjugate(a.orientation);
    const double sine_of_half = length(Vec3d{q.x, q.y, q.z});
    return length(b.position - a.position) + 2 * std::min(1.0, sine_of_half) * bounding_radius(body.collider);
}

}  // namespace

Difference compare_motions(const RigidScene& scene, const std::vector<Track>& a, const std::vector<Track>& b,
                           double begin, double end, double tolerance) {
    Difference out{0, std::numeric_limits<double>::infinity()};
    const int samples = int(std::clamp((end - begin) * samples_per_second, 1.0, double(most_samples)));
    for (int k = 0; k <= samples; ++k) {
        const double t = begin + (end - begin) * k / samples;
        double largest = 0;
        for (size_t i = 0; i < scene.bodies.size(); ++i) {
            if (scene.bodies[i].kind != RigidBody::Kind::dynamic) continue;
            const double d =
                apart(scene.bodies[i], state_at(scene.bodies[i], a[i], t), state_at(scene.bodies[i], b[i], t));
            largest = std::isnan(d) ? std::numeric_limits<double>::infinity() : std::max(largest, d);
        }
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
    const auto trust = [&](double until) {
        until = std::min(until, out.audit.fails_from);
        out.trusted_until = std::min({end, until, out.simulation.given_up.time});
    };
    trust(end);
    if (out.simulation.impacts.empty() && out.simulation.contact_steps == 0) return out;  // nothing touches anything

    const RigidScene displaced = perturbed(scene);
    const auto compare = [&](const Simulation& other, double until) {
        return compare_motions(scene, out.simulation.tracks, other.tracks, begin, until, tolerance);
    };
    const auto start = [&](const RigidScene& s, double step) {
        return std::async(std::launch::async, simulate, std::cref(s), begin, end, step);
    };
    std::future<Simulation> twin = start(displaced, out.step);
    std::vector<std::future<Simulation>> finer;  // those that are needed in any case
    if (out.simulation.contact_steps > 0) {
        finer.push_back(start(scene, out.step / 2));
        if (2 * out.simulation.contact_points <= most_points) finer.push_back(start(scene, out.step / 4));
    }
    const Difference start_matters = compare(twin.get(), end);
    ++out.runs;
    const double horizon = std::min(end, start_matters.from);
    out.is_chaotic = start_matters.from < end;
    trust(horizon);
    if (finer.empty()) return out;

    int agreements = 0;
    Simulation coarser;
    for (size_t k = 0; k < most_halvings && agreements < 2; ++k) {
        if (k > 0 && out.simulation.contact_points > most_points) break;
        coarser = std::exchange(out.simulation,
                                k < finer.size() ? finer[k].get() : simulate(scene, begin, end, out.step / 2));
        ++out.runs;
        out.step /= 2;
        const Difference d = compare(coarser, horizon);
        out.error = d.largest;
        out.audit = audit(scene, out.simulation.tracks, end);
        trust(std::min(horizon, d.from));
        const bool agrees = d.from >= horizon && out.audit.passes();
        agreements = agrees ? agreements + 1 : 0;
    }
    const Difference steps = compare(coarser, end);
    if (out.is_chaotic && steps.from > horizon) {  // which was that of the longest steps
        const double from = compare(simulate(displaced, begin, end, out.step), end).from;
        ++out.runs;
        out.error = steps.largest;
        trust(std::min(steps.from, from));
        out.is_chaotic = from <= steps.from && from < end;
    } else {
        out.is_chaotic = out.is_chaotic && steps.from >= horizon;
    }
    return out;
}

}  // namespace drt
