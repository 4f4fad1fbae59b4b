#pragma once
// A scene with physics for the end-to-end tests.

#include <string>

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

/// `text` with one part replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
}

}  // namespace drt
