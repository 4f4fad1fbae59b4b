#pragma once
// What is simulated: rigid bodies as plain values. Lengths are in units of the scene's own scale (build_rigid_scene
// divides by the size of the smallest moving body, so that every threshold below is relative to it), times in seconds.

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "drt/base/quat.h"
#include "drt/base/vec.h"

namespace drt {

// Colliders, centred on the body's position and in its own axes.
struct SphereCollider {
    double radius = 1;
};
struct BoxCollider {
    Vec3d half{1, 1, 1};
};
struct CylinderCollider {  ///< about the z axis, capped
    double radius = 1, half_height = 1;
};
struct PlaneCollider {  ///< everything below it is solid; cannot move freely
    Vec3d normal{0, 1, 0};
};
struct PolygonCollider {  ///< flat, convex, solid from both sides; cannot move freely
    std::vector<Vec3d> vertices;
};
struct DiscCollider {  ///< flat, solid from both sides; cannot move freely
    Vec3d normal{0, 1, 0};
    double radius = 1;
};
using Collider =
    std::variant<SphereCollider, BoxCollider, CylinderCollider, PlaneCollider, PolygonCollider, DiscCollider>;

struct RigidState {
    Vec3d position;
    Quatd orientation;
    Vec3d velocity;
    Vec3d spin;  ///< angular velocity about the world's axes, radians / s
};

/// What a body does from one event to the next.
struct Path {
    double begin = 0;    ///< time
    RigidState from;     ///< at `begin`
    Vec3d acceleration;  ///< constant
    /// Free: the body tumbles as its inertia wants. Otherwise it turns at a constant spin.
    bool free = true;
};

/// Paths of one body in ascending order; each holds until the next begins, the last one for ever.
using Track = std::vector<Path>;

/// At `time` the momentum changes by `impulse`, struck at `at` (from the centre, along the world's axes).
struct Blow {
    double time = 0;
    Vec3d impulse, at;
};

/// A force at the centre for a while.
struct Push {
    double from = 0, until = 0;
    Vec3d force;
};

struct RigidBody {
    enum class Kind { fixed, dynamic, kinematic };
    Kind kind = Kind::fixed;
    Collider collider;
    double mass = 1;
    Vec3d inertia{1, 1, 1};  ///< about the body's own axes, which are principal
    double friction = 0.5;
    double rolling_friction = 0;  ///< torque / (normal force * radius)
    double restitution = 0;
    RigidState start;
    std::vector<Blow> blows;   ///< on dynamic bodies, in ascending order
    std::vector<Push> pushes;  ///< on dynamic bodies
    Track course;              ///< of kinematic bodies: paths that are not free
};

struct RigidScene {
    std::vector<RigidBody> bodies;
    Vec3d gravity;
};

/// What two bodies' surfaces have together.
inline double combined_friction(const RigidBody& a, const RigidBody& b) { return std::sqrt(a.friction * b.friction); }
inline double combined_rolling_friction(const RigidBody& a, const RigidBody& b) {
    return std::max(a.rolling_friction, b.rolling_friction);
}
inline double combined_restitution(const RigidBody& a, const RigidBody& b) {
    return std::max(a.restitution, b.restitution);
}

}  // namespace drt
