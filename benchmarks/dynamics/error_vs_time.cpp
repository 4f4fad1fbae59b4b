// Error against run time of the simulation: drt's with each step, drt's controller with each tolerance, and Bullet's
// own stepping with its default and its best settings. A table as CSV on standard output; plot.py draws it.
//
//   error_vs_time [NAME]     # all motions, or those of that name: bounce, collision, roll, stack, break
//
// Errors are the largest distance of a body's centre from the truth, in radii of the balls (half sides of the cubes),
// at 96 instants a second. A break has no closed form: the truth is drt's own run with the finest step, until it can no
// longer be trusted. Costs are CPU time, the median of several runs.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "bullet_stepping.h"
#include "drt/dynamics/control.h"
#include "motions.h"

namespace drt::bench {
namespace {

constexpr int instants_a_second = 96;
constexpr double reference_step = 1.0 / 6144;
constexpr double trust = 1e-3;         // runs that differ by more are no truth
constexpr double perturbation = 1e-9;  // of the start

double cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

// Median of 3 to 5 runs, of one or two if that takes long.
template <typename F>
double milliseconds(const F& run) {
    std::vector<double> times;
    double sum = 0;
    while (times.empty() || (sum < 0.2 && times.size() < 5) || (sum < 0.4 && times.size() < 3)) {
        const double begin = cpu_seconds();
        run();
        times.push_back(cpu_seconds() - begin);
        sum += times.back();
    }
    std::nth_element(times.begin(), times.begin() + long(times.size() / 2), times.end());
    return 1e3 * times[times.size() / 2];
}

struct Truth {
    Exact at;
    std::vector<double> times;
    double until = 0;
};

// Until when the finest run, one with twice its step and one from a start that differs by next to nothing agree.
Truth finest_run(const Motion& m) {
    const auto run = [&](const RigidScene& s, double step) { return simulate(s, 0, m.end, step).tracks; };
    RigidScene other = m.scene;
    for (size_t i = 0; i < other.bodies.size(); ++i)
        if (other.bodies[i].kind == RigidBody::Kind::dynamic)
            other.bodies[i].start.position +=
                Vec3d{std::sin(2.0 * double(i)), 0, std::cos(3.0 * double(i))} * perturbation;
    const std::vector<Track> finest = run(m.scene, reference_step);
    double until = m.end;
    for (const auto& tracks : {run(m.scene, 2 * reference_step), run(other, reference_step)})
        until = std::min(until, compare_motions(m.scene, finest, tracks, 0, m.end, trust).from);
    const Exact at = [&m, finest](size_t body, double t) {
        return state_at(m.scene.bodies[body], finest[body], t).position;
    };
    return {at, {}, until};
}

Truth truth_of(const Motion& m) {
    Truth t = m.exact ? Truth{m.exact, {}, m.end} : finest_run(m);
    for (int k = 0; k <= int(t.until * instants_a_second); ++k) t.times.push_back(double(k) / instants_a_second);
    return t;
}

template <typename F>  // position of a body at the k-th instant
double largest_error(const Motion& m, const Truth& truth, const F& position) {
    double worst = 0;
    for (size_t k = 0; k < truth.times.size(); ++k)
        for (size_t i = 0; i < m.scene.bodies.size(); ++i) {
            if (m.scene.bodies[i].kind != RigidBody::Kind::dynamic) continue;
            const double d = length(position(i, k) - truth.at(i, truth.times[k]));
            worst = std::isfinite(d) ? std::max(worst, d) : d;
        }
    return worst;
}

struct Row {
    std::string method;
    double setting = 0;  ///< step in seconds, or tolerance
    double error = 0, milliseconds = 0;
    long steps = 0;  ///< in contact (drt) or at all (Bullet), of the last run
    size_t impacts = 0;
    int runs = 1;
    double trusted = 0;  ///< until when, by the controller
};

void print(const Motion& m, const Truth& truth, const Row& r) {
    fmt::print("{},\"{}\",{},{:.6g},{:.3e},{:.4g},{},{},{},{:.4g},{:.4g}\n", m.name, m.variant, r.method, r.setting,
               r.error, r.milliseconds, r.steps, r.impacts, r.runs, truth.until, r.trusted);
    std::fflush(stdout);
}

double error_of(const Motion& m, const Truth& truth, const Simulation& s) {
    return largest_error(m, truth, [&](size_t body, size_t k) {
        return state_at(m.scene.bodies[body], s.tracks[body], truth.times[k]).position;
    });
}

void measure_drt(const Motion& m, const Truth& truth) {
    for (int per_second = 24; per_second <= 1536; per_second *= 2) {
        Row r{"step", 1.0 / per_second};
        Simulation s;
        r.milliseconds = milliseconds([&] { s = simulate(m.scene, 0, truth.until, r.setting); });
        r.error = error_of(m, truth, s);
        r.steps = s.contact_steps;
        r.impacts = s.impacts.size();
        print(m, truth, r);
    }
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        Row r{"controller", tolerance};
        Controlled c;
        r.milliseconds = milliseconds([&] { c = simulate_controlled(m.scene, 0, truth.until, tolerance); });
        r.error = error_of(m, truth, c.simulation);
        r.steps = c.simulation.contact_steps;
        r.impacts = c.simulation.impacts.size();
        r.runs = c.runs;
        r.trusted = c.trusted_until;
        print(m, truth, r);
    }
}

void measure_bullet(const Motion& m, const Truth& truth) {
    for (const bool tuned : {false, true})
        for (int per_second = 96; per_second <= m.most_steps_a_second; per_second *= 2) {
            Row r{tuned ? "bullet-tuned" : "bullet", 1.0 / per_second};
            std::vector<std::vector<Vec3d>> positions;
            r.milliseconds = milliseconds([&] {
                positions = bullet_positions(m.scene, truth.times, r.setting, {tuned, m.in_flight});
            });
            r.error = largest_error(m, truth, [&](size_t body, size_t k) { return positions[k][body]; });
            r.steps = std::lround(truth.times.back() * per_second);
            print(m, truth, r);
        }
}

}  // namespace
}  // namespace drt::bench

int main(int argc, char** argv) {
    using namespace drt::bench;
    fmt::print("motion,variant,method,setting,error,milliseconds,steps,impacts,runs,until,trusted\n");
    for (const Motion& m : all_motions()) {
        if (argc > 1 && m.name != argv[1]) continue;
        const Truth truth = truth_of(m);
        measure_drt(m, truth);
        measure_bullet(m, truth);
    }
}
