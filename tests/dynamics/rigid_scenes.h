#pragma once
// Bodies for tests, in the units of the rigid scene.

#include <cmath>

#include "drt/base/constants.h"
#include "drt/dynamics/simulate.h"

namespace drt::test {

inline RigidBody floor_body(double restitution = 0) {
    RigidBody b;
    b.collider = PlaneCollider{};
    b.restitution = restitution;
    return b;
}

inline RigidBody ball(const Vec3d& position, double restitution, double radius = 1, double mass = 1) {
    RigidBody b;
    b.kind = RigidBody::Kind::dynamic;
    b.collider = SphereCollider{radius};
    b.mass = mass;
    const double inertia = 0.4 * mass * radius * radius;
    b.inertia = {inertia, inertia, inertia};
    b.restitution = restitution;
    b.start.position = position;
    return b;
}

inline RigidBody box(const Vec3d& position, const Vec3d& half, double restitution) {
    RigidBody b;
    b.kind = RigidBody::Kind::dynamic;
    b.collider = BoxCollider{half};
    const Vec3d s{half.x * half.x, half.y * half.y, half.z * half.z};
    b.inertia = Vec3d{s.y + s.z, s.x + s.z, s.x + s.y} * (1.0 / 3);
    b.restitution = restitution;
    b.start.position = position;
    return b;
}

/// Cubes of half a side 1 on each other, the uppermost so many times as heavy as the others.
inline RigidScene stack(int count, double heavy) {
    RigidScene scene{{floor_body()}, {0, -9.81, 0}};
    for (int i = 0; i < count; ++i) scene.bodies.push_back(box({0, 1 + 2.0 * i, 0}, {1, 1, 1}, 0));
    scene.bodies.back().mass *= heavy;
    scene.bodies.back().inertia = scene.bodies.back().inertia * heavy;
    return scene;
}

/// Fifteen balls in a rack, so far apart, on a floor that they slide and roll on, and one that comes at them.
inline RigidScene billiard_break(double gap) {
    std::vector<RigidBody> balls;
    for (int row = 0; row < 5; ++row)
        for (int k = 0; k <= row; ++k)
            balls.push_back(ball({row * (2 + gap) * std::sqrt(0.75), 1, (k - row / 2.0) * (2 + gap)}, 0.95));
    balls.push_back(ball({-20, 1, 0.1}, 0.95));
    balls.back().start.velocity = {200, 0, 0};
    for (RigidBody& b : balls) b.friction = 0.1;
    balls.insert(balls.begin(), floor_body());
    return {std::move(balls), {0, -9.81 / 0.0286, 0}};
}

/// Height above its rest of a ball dropped from `height` that bounces with restitution e under gravity g.
inline double bounce_height(double time, double height, double e, double g) {
    const double fall = std::sqrt(2 * height / g);
    if (time < fall) return height - 0.5 * g * time * time;
    double speed = g * fall;
    time -= fall;
    for (int k = 0; k < 10000; ++k) {
        speed *= e;
        const double flight = 2 * speed / g;
        if (flight < 1e-12) return 0;
        if (time < flight) return speed * time - 0.5 * g * time * time;
        time -= flight;
    }
    return 0;
}

inline double momentum_error(const RigidScene& s, const std::vector<RigidState>& a, const std::vector<RigidState>& b) {
    Vec3d before, after;
    for (size_t i = 0; i < a.size(); ++i) {
        before += a[i].velocity * s.bodies[i].mass;
        after += b[i].velocity * s.bodies[i].mass;
    }
    return length(after - before) / length(before);
}

}  // namespace drt::test
