#include "drt/dynamics/impact_time.h"

#include <algorithm>
#include <cmath>

#include "drt/dynamics/contacts.h"

namespace drt {

namespace {

constexpr int most_steps = 100000;
constexpr double corner_step = 1e-7;  // that a corner of a body goes between two looks while another one parts

// The smallest positive root of gap = speed t + acceleration t^2 / 2; infinite if there is none.
double time_to_close(double gap, double speed, double acceleration) {
    const double discriminant = speed * speed + 2 * acceleration * gap;
    if (discriminant < 0) return never;
    const double divisor = speed + std::sqrt(discriminant);
    return divisor > 0 ? 2 * gap / divisor : never;
}

// A tumbling body's spin stays below this: its energy is constant.
double largest_spin(const RigidBody& b, const Path& p) {
    const Vec3d i = b.inertia;
    const double spread = p.free ? std::sqrt(std::max({i.x, i.y, i.z}) / std::min({i.x, i.y, i.z})) : 1;
    return length(p.from.spin) * spread;
}

}  // namespace

std::optional<double> impact_time(const ContactWorld& world, const RigidScene& scene, int a, const Path& path_a, int b,
                                  const Path& path_b, double begin, double end) {
    const RigidBody &body_a = scene.bodies[size_t(a)], &body_b = scene.bodies[size_t(b)];
    const double spin_a = largest_spin(body_a, path_a), spin_b = largest_spin(body_b, path_b);
    const double reach_a = corner_reach(body_a.collider), reach_b = corner_reach(body_b.collider);
    const double rim = spin_a * reach_a + spin_b * reach_b;
    const double bounds = bounding_radius(body_a.collider) + bounding_radius(body_b.collider);
    const Vec3d pull = path_a.acceleration - path_b.acceleration;
    double t = begin;
    for (int k = 0; k < most_steps && t <= end; ++k) {
        // While the spheres about the bodies are apart, their orientations do not matter.
        const double seconds_a = t - path_a.begin, seconds_b = t - path_b.begin;
        const Vec3d apart = position_at(path_a, seconds_a) - position_at(path_b, seconds_b);
        const Vec3d relative = velocity_at(path_a, seconds_a) - velocity_at(path_b, seconds_b);
        if (const double d = length(apart), gap = d - bounds; gap > 0.01 * d) {
            t += time_to_close(gap, -dot(relative, apart) / d, -dot(pull, apart) / d);
            continue;
        }
        const RigidState sa = state_at(body_a, path_a, t), sb = state_at(body_b, path_b, t);
        const Nearest near = nearest_bodies(world, scene, a, sa, b, sb);
        const double speed = -dot(relative, near.normal), acceleration = -dot(pull, near.normal);
        if (near.distance > near.error) {
            t += std::max(time_to_close(near.distance, speed + rim, acceleration), 1e-15 * std::abs(t));
            continue;
        }
        const Vec3d va = sa.velocity + cross(sa.spin, near.point - sa.position);
        const Vec3d vb = sb.velocity + cross(sb.spin, near.point - sb.position);
        const double approach = -dot(va - vb, near.normal);
        if (approach > 0) return t;
        // Parting: look again when it is apart, but before it can be back, or another corner there.
        if (rim > 0)
            t += std::max(corner_step, -0.1 * near.distance) / (rim + length(relative));
        else
            t += std::max(1e-10, std::min(1e-3 * (end - t), acceleration > 0 ? -approach / acceleration : never));
    }
    if (t <= end) return t;  // no progress: whoever asks looks at the contacts
    return std::nullopt;
}

}  // namespace drt
