#pragma once
// Small scenes for the tests of the plan.

#include "drt/plan/plan.h"
#include "support/scene_parts.h"

namespace drt::test {

/// A camera at the origin that looks along -z, and one grey material.
inline SceneDesc empty_scene() {
    SceneDesc s;
    s.render.width = 64;
    s.render.height = 48;
    s.render.filter.kind = Filter::Kind::point;
    s.materials = {matte("grey", Color(0.5f))};
    Camera c;
    c.name = "camera";
    c.positions = {{0, 0, 0}};
    c.targets = {{0, 0, -1}};
    s.cameras = {c};
    return s;
}

inline SceneDesc scene_with(const Shape& shape) {
    SceneDesc s = empty_scene();
    s.bodies = {body("body", shape, "grey")};
    return s;
}

}  // namespace drt::test
