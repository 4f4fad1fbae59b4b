#pragma once
// Small scenes with physics.

#include "drt/bake/bake.h"
#include "drt/base/constants.h"
#include "support/scene_parts.h"

namespace drt::test {

/// A camera at z = 20 that looks at the origin through 100 pixels, from video time 0 to 2.
inline SceneDesc scene_with_camera() {
    SceneDesc s;
    s.render.width = 100;
    s.render.height = 100;
    s.materials = {matte("grey", Color(0.5f))};
    Camera c;
    c.name = "camera";
    c.positions = {{0, 0, 20}};
    c.fov_degrees_start = 90;
    c.video_end = 2;
    s.cameras = {c};
    return s;
}

inline Body with_physics(const Shape& shape, PhysicsDesc::Kind kind = PhysicsDesc::Kind::dynamic) {
    Body b = body("", shape, "grey");
    b.physics.emplace();
    b.physics->kind = kind;
    return b;
}

/// Thrown into the air, and nothing else.
inline SceneDesc flying_ball() {
    SceneDesc s = scene_with_camera();
    s.bodies = {with_physics(sphere({1, 2, 3}, 0.5))};
    s.bodies[0].name = "ball";
    s.bodies[0].physics->velocity = {1, 5, -2};
    s.bodies[0].physics->angular_velocity_degrees = {0, 90, 0};
    return s;
}

inline BakeInput input_over(const SceneDesc& scene, double begin, double end) {
    BakeInput in = bake_input(scene, end);
    in.begin = begin;
    in.end = end;
    return in;
}

}  // namespace drt::test
