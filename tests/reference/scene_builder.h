#pragma once
// Scenes of one pixel in grey, for comparison with closed forms.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/reference.h"
#include "support/scene_parts.h"

namespace drt {

inline Material matte(const std::string& name, float grey) { return matte(name, Color(grey)); }
inline Material glow(const std::string& name, float grey = 1) { return glow(name, Color(grey)); }
inline Body body(const Shape& shape, const std::string& material) { return body("body", shape, material); }
inline Light light(const LightShape& shape, float grey, Light::Falloff falloff = Light::Falloff::inverse_square) {
    return light("light", shape, Color(grey), falloff);
}

/// A pinhole with an instantaneous shutter and the point filter: one ray through each pixel's centre. Bodies glow by
/// an ambient light of 1.
inline SceneDesc still_scene(const Vec3d& eye, const Vec3d& target, const Vec3d& up = {0, 1, 0}) {
    SceneDesc scene;
    scene.ambient_light = Color(1.0f);
    scene.render.filter.kind = Filter::Kind::point;
    Camera camera;
    camera.positions = {eye};
    camera.targets = {target};
    camera.up_start = up;
    camera.shutter.duration = 0;
    scene.cameras = {camera};
    return scene;
}

struct Value {
    double mean = 0, sigma = 0;
};

/// Red channel of one pixel.
inline Value value_of(const ReferencePicture& picture, int x = 0, int y = 0) {
    return {picture.mean[picture.index(x, y)].r, std::sqrt(picture.variance[picture.index(x, y)].r)};
}

/// Of a picture of one pixel: the central ray, where the filter is `point`.
inline Value render_pixel(const SceneDesc& scene, int spp = 2, std::uint64_t seed = 1, int frame = 0) {
    return value_of(render_reference(scene, frame, 1, 1, spp, seed));
}

/// Within 4 standard errors (6e-5 of false alarms, at fixed seeds) and rounding.
#define EXPECT_ESTIMATE(value, truth)                                         \
    do {                                                                      \
        const Value v_ = (value);                                             \
        const double truth_ = (truth);                                        \
        EXPECT_NEAR(v_.mean, truth_, 4 * v_.sigma + 1e-6 * std::abs(truth_)); \
    } while (false)

}  // namespace drt
