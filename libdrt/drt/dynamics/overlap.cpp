#include "drt/dynamics/overlap.h"

#include <algorithm>

namespace drt {

namespace {

constexpr int most_rounds = 50;
constexpr double small = 1e-12;

}  // namespace

PushedApart push_apart(const RigidScene& scene, const std::vector<Contact>& contacts, std::vector<RigidState>& states) {
    const auto lightness = [&](int i) {
        const RigidBody& b = scene.bodies[size_t(i)];
        return b.kind == RigidBody::Kind::dynamic ? 1 / b.mass : 0;
    };
    PushedApart out;
    std::vector<Vec3d> way(states.size());
    for (int round = 0; round < most_rounds; ++round) {
        double deepest = 0;
        for (const Contact& c : contacts)
            for (const ContactPoint& p : c.points()) {
                const double gap = p.gap + dot(way[size_t(c.a)] - way[size_t(c.b)], p.normal);
                if (gap >= 0) continue;
                deepest = std::max(deepest, -gap);
                const double a = lightness(c.a), b = lightness(c.b);
                way[size_t(c.a)] -= p.normal * (gap * a / (a + b));
                way[size_t(c.b)] += p.normal * (gap * b / (a + b));
            }
        out.deepest = std::max(out.deepest, deepest);
        if (deepest < small) break;
    }
    for (size_t i = 0; i < states.size(); ++i) {
        if (way[i] == Vec3d{}) continue;
        states[i].position += way[i];
        out.moved.push_back(int(i));
    }
    return out;
}

}  // namespace drt
