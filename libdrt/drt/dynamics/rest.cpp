#include "drt/dynamics/rest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace drt {

namespace {

constexpr double rest_speed = 1e-5, rest_time = 0.5;

// Of bodies that touch, directly or through other moving bodies: one of them stands for all.
std::vector<int> islands(const RigidScene& scene, const std::vector<Contact>& holding) {
    std::vector<int> island(scene.bodies.size());
    std::iota(island.begin(), island.end(), 0);
    const auto root = [&](int i) {
        while (island[size_t(i)] != i) i = island[size_t(i)] = island[size_t(island[size_t(i)])];
        return i;
    };
    const auto moves = [&](int i) { return scene.bodies[size_t(i)].kind == RigidBody::Kind::dynamic; };
    for (const Contact& c : holding)
        if (moves(c.a) && moves(c.b)) island[size_t(root(c.a))] = root(c.b);
    for (int i = 0; i < int(island.size()); ++i) island[size_t(i)] = root(i);
    return island;
}

}  // namespace

Rest::Rest(const RigidScene& scene)
    : scene_(scene), quiet_since_(scene.bodies.size(), never), bed_(scene.bodies.size(), awake) {}

bool Rest::is_quiet(int body, const RigidState& s) const {
    return length(s.velocity) + length(s.spin) * bounding_radius(scene_.bodies[size_t(body)].collider) <
           rest_speed * std::sqrt(length(scene_.gravity));
}

std::vector<int> Rest::update(std::vector<RigidState>& states, const std::vector<bool>& held,
                              const std::vector<Contact>& holding, double time) {
    std::vector<bool> driven(states.size(), false);  // touched by a kinematic body
    for (const Contact& c : holding) {
        const auto is_kinematic = [&](int i) { return scene_.bodies[size_t(i)].kind == RigidBody::Kind::kinematic; };
        if (is_kinematic(c.a)) driven[size_t(c.b)] = true;
        if (is_kinematic(c.b)) driven[size_t(c.a)] = true;
    }
    const std::vector<int> island = islands(scene_, holding);
    std::vector<bool> rests(states.size(), true);  // by island
    for (size_t i = 0; i < states.size(); ++i) {
        if (!held[i]) continue;
        quiet_since_[i] = is_quiet(int(i), states[i]) && !driven[i] ? std::min(quiet_since_[i], time) : never;
        if (!(time - quiet_since_[i] >= rest_time / std::sqrt(length(scene_.gravity))))
            rests[size_t(island[i])] = false;
    }
    std::vector<int> changed;
    ++beds_;
    for (size_t i = 0; i < states.size(); ++i) {
        if (!held[i]) continue;
        const bool sleeps = rests[size_t(island[i])];
        if (sleeps != asleep(int(i))) changed.push_back(int(i));
        bed_[i] = sleeps ? beds_ * std::int64_t(states.size()) + island[i] : awake;
        if (sleeps) states[i].velocity = states[i].spin = {};
    }
    return changed;
}

std::vector<int> Rest::wake(int body) {
    std::vector<int> out{body};
    if (const std::int64_t bed = bed_[size_t(body)]; bed != awake)
        for (int i = 0; i < int(bed_.size()); ++i)
            if (bed_[size_t(i)] == bed && i != body) out.push_back(i);
    for (const int i : out) {
        bed_[size_t(i)] = awake;
        quiet_since_[size_t(i)] = never;
    }
    return out;
}

}  // namespace drt
