#pragma once
// A scene that is fine, one change to it, and the whole messages that validate() must give.

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "drt/scene/scene_desc.h"

namespace drt {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double inf = std::numeric_limits<double>::infinity();

inline SceneDesc valid_scene() {
    SceneDesc s;
    s.textures = {{"wood", "wood.png", {}}};
    s.materials.resize(2);
    s.materials[0].name = "red";
    s.materials[1].name = "planks";
    s.materials[1].texture = "wood";
    s.bodies.resize(2);
    s.bodies[0] = {"ball", Sphere{}, "red", {}, {}};
    s.bodies[1] = {"floor", Plane{}, "planks", {}, {}};
    s.lights.resize(1);
    s.lights[0] = {"sun", RectLight{}, Color{1.0f}, Light::Falloff::inverse_square, true};
    s.cameras.resize(1);
    s.cameras[0].name = "main";
    return s;
}

inline Motion two_keys() {
    Motion m;
    m.keys.resize(2);
    m.keys[1].time = 1;
    return m;
}

struct Case {
    std::string name;
    std::function<void(SceneDesc&)> change;
    std::vector<std::string> messages;  ///< each "path: severity: message..."
};

inline std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

// Each path that a message names is given a place of its own, so that a message which names another one fails.
inline Diagnostics validate_with_places(SceneDesc& scene, const std::vector<std::string>& messages) {
    scene.sources.places[""] = {"scene", 0, 0};
    for (const std::string& m : messages) {
        const std::string path = m.substr(0, m.find(": "));
        if (path != "scene") scene.sources.places[path] = {path, 0, 0};
    }
    return validate(scene);
}

inline std::vector<std::string> texts(const Diagnostics& diagnostics) {
    std::vector<std::string> out;
    for (const Diagnostic& d : diagnostics) out.push_back(to_string(d));
    return out;
}

inline std::string case_name(const testing::TestParamInfo<Case>& info) { return info.param.name; }

}  // namespace drt
