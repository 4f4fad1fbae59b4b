#include "motions.h"

#include <fmt/format.h>

#include <cmath>

#include "dynamics/rigid_scenes.h"

namespace drt::bench {

namespace {

using namespace test;

constexpr double g = 9.81;

Motion bounce(double e) {
    Motion m{"bounce", fmt::format("e = {}", e), {{floor_body(), ball({0, 6, 0}, e)}, {0, -g, 0}}, 12, {}, true};
    m.exact = [e](size_t body, double t) { return body == 0 ? Vec3d{} : Vec3d{0, 1 + bounce_height(t, 5, e, g), 0}; };
    return m;
}

// A smooth ball meets one at rest, so far off the line of centres, without loss of energy.
Motion collision(double offset, double mass) {
    constexpr double speed = 5, hit = 0.5037;  // seconds; of no step's multiple
    const Vec3d contact{-std::sqrt(4 - offset * offset), offset, 0}, velocity{speed, 0, 0};
    Motion m{"collision", fmt::format("offset {} r, masses 1 : {:g}", offset, mass), {}, 2, {}, true};
    m.scene.bodies = {ball(contact - velocity * hit, 1), ball({0, 0, 0}, 1, 1, mass)};
    m.scene.bodies[0].start.velocity = velocity;
    for (RigidBody& b : m.scene.bodies) b.friction = 0;
    const Vec3d n = normalize(contact), kick = n * (2 * mass / (1 + mass) * dot(velocity, n));
    m.exact = [=](size_t body, double t) {
        const double after = std::max(0.0, t - hit);
        return body == 0 ? contact + velocity * (t - hit) - kick * after : kick * (after / mass);
    };
    return m;
}

// A sliding ball slows down until it rolls, at 5/7 of its speed.
Motion roll() {
    constexpr double speed = 5, friction = 0.5;
    Motion m{"roll", "sliding to rolling", {{floor_body(), ball({0, 1, 0}, 0)}, {0, -g, 0}}, 2, {}};
    m.scene.bodies[1].start.velocity = {speed, 0, 0};
    m.exact = [=](size_t body, double t) {
        const double rolls_from = 2 * speed / (7 * friction * g), slides = std::min(t, rolls_from);
        const double x = speed * slides - 0.5 * friction * g * slides * slides + 5.0 / 7 * speed * (t - slides);
        return body == 0 ? Vec3d{} : Vec3d{x, 1, 0};
    };
    return m;
}

Motion stack_of_ten(double heavy) {
    Motion m{"stack", fmt::format("10 cubes, the top {:g} times as heavy", heavy), stack(10, heavy), 20, {}};
    std::vector<Vec3d> start;
    for (const RigidBody& b : m.scene.bodies) start.push_back(b.start.position);
    m.exact = [start](size_t body, double) { return start[body]; };
    m.most_steps_a_second = 768;
    return m;
}

Motion break_of_fifteen(double gap) {
    return {"break", fmt::format("15 balls, gap {:g}", gap), billiard_break(gap), 0.5, {}};
}

}  // namespace

std::vector<Motion> all_motions() {
    return {bounce(1),
            bounce(0.8),
            bounce(0.5),
            collision(1, 1),
            collision(1.8, 1000),
            roll(),
            stack_of_ten(1),
            stack_of_ten(100),
            stack_of_ten(1e4),
            break_of_fifteen(0),
            break_of_fifteen(1e-6),
            break_of_fifteen(1e-2)};
}

}  // namespace drt::bench
