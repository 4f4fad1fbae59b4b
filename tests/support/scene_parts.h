#pragma once
// Short names for building small scenes in tests.

#include <string>

#include "drt/scene/scene_desc.h"

namespace drt {

/// Diffuse only: black without lights.
inline Material matte(const std::string& name, const Color& diffuse) {
    Material m;
    m.name = name;
    m.ambient = Color(0.0f);
    m.diffuse = diffuse;
    return m;
}

/// Shows this colour times the scene's ambient light, whatever the lights.
inline Material glow(const std::string& name, const Color& ambient) {
    Material m = matte(name, Color(0.0f));
    m.ambient = ambient;
    return m;
}

inline Body body(const std::string& name, const Shape& shape, const std::string& material) {
    Body b;
    b.name = name;
    b.shape = shape;
    b.material = material;
    return b;
}

inline Sphere sphere(const Vec3d& center, double radius) {
    Sphere s;
    s.center = center;
    s.radius = radius;
    return s;
}

inline Light light(const std::string& name, const LightShape& shape, const Color& color,
                   Light::Falloff falloff = Light::Falloff::inverse_square) {
    Light l;
    l.name = name;
    l.shape = shape;
    l.color = color;
    l.falloff = falloff;
    return l;
}

inline MotionKey key(double time, const Vec3d& position, const std::optional<Quatd>& orientation = {}) {
    return {time, position, orientation, {}};
}

/// The key's orientation is the previous key's followed by this turn.
inline MotionKey turning_key(double time, const Vec3d& position, const Vec3d& axis, double degrees) {
    return {time, position, {}, Turn{axis, degrees}};
}

}  // namespace drt
