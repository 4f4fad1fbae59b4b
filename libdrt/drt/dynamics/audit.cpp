#include "drt/dynamics/audit.h"

#include <algorithm>
#include <cmath>

#include "drt/dynamics/nearest.h"

namespace drt {

namespace {

double energy(const RigidScene& scene, const RigidBody& b, const RigidState& s) {
    const Vec3d w = rotate_back(s.orientation, s.spin);
    return 0.5 * b.mass * length_squared(s.velocity) - b.mass * dot(scene.gravity, s.position) +
           0.5 * (b.inertia.x * w.x * w.x + b.inertia.y * w.y * w.y + b.inertia.z * w.z * w.z);
}

struct Change {
    double time;
    size_t body, path;
};

std::vector<Change> changes_in_order(const RigidScene& scene, const std::vector<Track>& tracks, double end) {
    std::vector<Change> out;
    for (size_t i = 0; i < tracks.size(); ++i)
        if (scene.bodies[i].kind == RigidBody::Kind::dynamic)
            for (size_t k = 0; k < tracks[i].size() && tracks[i][k].begin < end; ++k)
                out.push_back({tracks[i][k].begin, i, k});
    std::stable_sort(out.begin(), out.end(), [](const Change& a, const Change& b) { return a.time < b.time; });
    return out;
}

// Something else than gravity and contacts acts at this time.
bool is_driven(const RigidScene& scene, double time) {
    for (const RigidBody& b : scene.bodies) {
        for (const Blow& blow : b.blows)
            if (blow.time == time) return true;
        for (const Push& p : b.pushes)
            if (p.from <= time && time <= p.until) return true;
    }
    return false;
}

void note(Audit& a, double& worst, double value, double allowed, double time) {
    if (!(value <= allowed)) a.fails_from = std::min(a.fails_from, time);
    if (value <= worst) return;
    worst = value;
    if (value / allowed >= std::max(a.energy_rise / a.most_energy_rise, a.restitution_error / a.most_restitution_error))
        a.worst_time = time;
}

void check_energy(const RigidScene& scene, const std::vector<Track>& tracks, double end, Audit& result) {
    for (const RigidBody& b : scene.bodies)
        if (b.kind == RigidBody::Kind::kinematic) return;  // it does work
    const std::vector<Change> changes = changes_in_order(scene, tracks, end);
    std::vector<double> energies(tracks.size(), 0), kinetic(tracks.size(), 0);
    double largest_kinetic = 0, least = 0;
    const auto sum = [](const std::vector<double>& v) {
        double s = 0;
        for (const double x : v) s += x;
        return s;
    };
    std::vector<std::pair<double, double>> rises;  // time, rise
    for (size_t k = 0; k < changes.size();) {
        const double time = changes[k].time;
        for (; k < changes.size() && changes[k].time == time; ++k) {
            const Change& c = changes[k];
            const RigidBody& b = scene.bodies[c.body];
            const Track& track = tracks[c.body];
            // In contact a path has the mean velocity of its step: that of its middle.
            const bool is_step = !track[c.path].free && c.path + 1 < track.size();
            const RigidState s = state_at(b, track[c.path], is_step ? 0.5 * (time + track[c.path + 1].begin) : time);
            energies[c.body] = energy(scene, b, s);
            kinetic[c.body] = energies[c.body] + b.mass * dot(scene.gravity, s.position);
        }
        const double now = sum(energies);
        largest_kinetic = std::max(largest_kinetic, sum(kinetic));
        if (rises.empty() || is_driven(scene, time)) least = now;
        least = std::min(least, now);
        rises.push_back({time, now - least});
    }
    double heaviest = 0;
    for (const RigidBody& b : scene.bodies)
        if (b.kind == RigidBody::Kind::dynamic) heaviest = std::max(heaviest, b.mass);
    const double scale = largest_kinetic + heaviest * length(scene.gravity);  // times L = 1
    if (scale <= 0) return;
    for (const auto& [time, rise] : rises)
        note(result, result.energy_rise, rise / scale, Audit::most_energy_rise, time);
}

// ---- bounces --------------------------------------------------------------------------------------------------------

// Changes of velocity that are less than this apart are one contact: methods that take steps need some for a bounce.
double episode_length(const RigidScene& scene) {
    const double g = length(scene.gravity);
    return g > 0 ? 0.05 / std::sqrt(g) : 0.05;
}

bool jumps(const RigidBody& b, const Track& track, size_t k) {
    const Vec3d before = state_at(b, track[k - 1], track[k].begin).velocity, after = track[k].from.velocity;
    return length(after - before) > 1e-6 * (length(before) + length(after));
}

// The only other body within reach, or -1.
int only_neighbour(const RigidScene& scene, const std::vector<Track>& tracks, size_t body, double time, Nearest& at) {
    int found = -1;
    for (size_t j = 0; j < scene.bodies.size(); ++j) {
        if (j == body) continue;
        const RigidState a = state_at(scene.bodies[body], tracks[body], time);
        const RigidState b = state_at(scene.bodies[j], tracks[j], time);
        const auto near = nearest_in_closed_form(scene.bodies[body].collider, a, scene.bodies[j].collider, b);
        if (!near || near->distance > 0.1) continue;
        if (found >= 0) return -1;
        found = int(j);
        at = *near;
    }
    return found;
}

void check_bounce(const RigidScene& scene, const std::vector<Track>& tracks, size_t body, size_t first, size_t last,
                  Audit& result) {
    const RigidBody& b = scene.bodies[body];
    const Track& track = tracks[body];
    const double time = track[last].begin;
    Nearest near;
    const int other = only_neighbour(scene, tracks, body, time, near);
    if (other < 0 || scene.bodies[size_t(other)].kind != RigidBody::Kind::fixed) return;
    for (size_t k = first; k < last; ++k)
        if (Nearest then; only_neighbour(scene, tracks, body, track[k].begin, then) != other) return;
    for (size_t k = first; k <= last; ++k)
        if (is_driven(scene, track[k].begin)) return;
    const double in = -dot(state_at(b, track[first - 1], time).velocity, near.normal);
    const double out = dot(track[last].from.velocity, near.normal);
    if (in < 0.5 * std::sqrt(length(scene.gravity)) || in < 1e-3 * length(track[first - 1].from.velocity)) return;
    ++result.bounces;
    const double expected = combined_restitution(b, scene.bodies[size_t(other)]);
    note(result, result.restitution_error, std::abs(out / in - expected), Audit::most_restitution_error, time);
}

void check_bounces(const RigidScene& scene, const std::vector<Track>& tracks, size_t body, double end, Audit& result) {
    const RigidBody& b = scene.bodies[body];
    const Track& track = tracks[body];
    const double episode = episode_length(scene);
    double last_jump = track.empty() ? 0 : track[0].begin;
    for (size_t k = 1; k < track.size(); ++k) {
        if (!jumps(b, track, k)) continue;
        const size_t first = k;
        size_t last = k;
        while (k + 1 < track.size() && track[k + 1].begin - track[first].begin < episode)
            if (jumps(b, track, ++k)) last = k;
        const bool alone_before = track[first].begin - last_jump >= episode && track[first - 1].free;
        if (alone_before && track[last].begin + episode < end) check_bounce(scene, tracks, body, first, last, result);
        last_jump = track[last].begin;
    }
}

}  // namespace

Audit audit(const RigidScene& scene, const std::vector<Track>& tracks, double end) {
    Audit result;
    check_energy(scene, tracks, end, result);
    for (size_t i = 0; i < tracks.size(); ++i)
        if (scene.bodies[i].kind == RigidBody::Kind::dynamic &&
            std::holds_alternative<SphereCollider>(scene.bodies[i].collider))
            check_bounces(scene, tracks, i, end, result);
    return result;
}

}  // namespace drt
