#pragma once
// A scene with physics for the end-to-end tests.

#include <string>

#include "drt/base/vec.h"

namespace drt {

/// A bouncing ball, a box that it pushes, and a door in motion, seen by a camera for two seconds of ten frames each.
inline const std::string physics_scene = R"(drt: 1
render: {width: 24, height: 16, fps: 10, spp: 4}
ambient_light: 1
simulation: {tolerance: 0.01}
materials:
  - {name: red, ambient: [0.7, 0.1, 0.08]}
  - {name: grey, ambient: 0.3}
bodies:
  - {name: ball, type: sphere, center: [-1, 2, 0], radius: 0.5, material: red, physics: {mass: 2, velocity: [2, 0, 0], restitution: 0.6}}
  - {name: box, type: box, center: [1, 0.5, 0], size: [1, 1, 1], material: red, physics: {}}
  - name: door
    type: box
    center: [3, 1, 0]
    size: [0.2, 2, 2]
    material: grey
    motion: {keys: [{time: 0, position: [3, 1, 0]}, {time: 2, position: [2, 1, 0]}]}
    physics: {kind: kinematic}
  - {name: floor, type: plane, material: grey, physics: {kind: static}}
cameras:
  - {name: main, video_end: 2, position: [0, 2, 8], target: [0, 1, 0], fov_degrees: 40}
)";

/// Balls in a box that never lose speed: minutes of simulation.
inline std::string endless_physics_scene() {
    std::string text = R"(drt: 1
gravity: [0, 0, 0]
simulation: {tolerance: 1e-6, end: 1e6}
materials: [{name: red, ambient: [0.7, 0.1, 0.08]}]
cameras: [{position: [0, 0, 8]}]
bodies:
)";
    const auto numbers = [](double x, double y, double z) {
        return '[' + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + ']';
    };
    for (int i = 0; i < 18; ++i)
        text += "  - {type: sphere, radius: 0.5, center: " +
                numbers(i % 3 * 1.3 - 1.3, i / 3 % 3 * 1.3 - 1.3, i / 9 * 1.3) +
                ", material: red, physics: {restitution: 1, friction: 0, velocity: " +
                numbers(1 + i % 5, i % 4 - 2, i % 7 - 3) + "}}\n";
    for (int side = 0; side < 6; ++side) {
        const double way = side % 2 ? 1 : -1;
        const Vec3d normal{side / 2 == 0 ? way : 0, side / 2 == 1 ? way : 0, side / 2 == 2 ? way : 0};
        text += "  - {type: plane, position: " + numbers(-2 * normal.x, -2 * normal.y, -2 * normal.z) +
                ", normal: " + numbers(normal.x, normal.y, normal.z) +
                ", material: red, physics: {kind: static, friction: 0}}\n";
    }
    return text;
}

}  // namespace drt
