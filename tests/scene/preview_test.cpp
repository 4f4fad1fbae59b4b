#include "drt/scene/preview.h"

#include <gtest/gtest.h>

#include "drt/base/constants.h"

namespace drt {
namespace {

Light light(const LightShape& shape, Light::Falloff falloff) {
    Light l;
    l.shape = shape;
    l.color = {1, 2, 4};
    l.falloff = falloff;
    l.visible = falloff == Light::Falloff::inverse_square;
    return l;
}

SceneDesc distributed_scene() {
    SceneDesc s;
    s.render.spp = 576;
    s.render.filter = {Filter::Kind::gaussian, 0.5, 1.0 / 3};
    Material glossy;
    glossy.reflectance = 0.5;
    glossy.reflection_spread_degrees = 8;
    glossy.refraction_spread_degrees = 3;
    s.materials = {glossy};
    Camera c;
    c.lens.aperture_radius = 0.35;
    c.lens.focus_start = 7;
    c.shutter = {std::nullopt, 0.2};
    s.cameras = {c, c};
    const RectLight rect{.corner = {0, 4, 0}, .edge_x = {2, 0, 0}, .edge_y = {0, 0, 3}};
    const SphereLight bulb{.center = {1, 2, 3}, .radius = 2};
    for (const Light::Falloff f : {Light::Falloff::none, Light::Falloff::inverse_square})
        for (const LightShape& shape : {LightShape(rect), LightShape(bulb), LightShape(PointLight{{9, 8, 7}})})
            s.lights.push_back(light(shape, f));
    return s;
}

TEST(Preview, EveryDistributedEffectIsOffAndNothingElseChanges) {
    const SceneDesc s = distributed_scene(), p = without_distributed_effects(s);
    SceneDesc expected = s;
    expected.render.spp = 1;
    expected.render.filter.kind = Filter::Kind::point;
    expected.materials[0].reflection_spread_degrees = 0;
    expected.materials[0].refraction_spread_degrees = 0;
    for (Camera& c : expected.cameras) {
        c.lens.aperture_radius = 0;
        c.shutter.duration = 0;
    }
    expected.lights = p.lights;
    EXPECT_TRUE(p == expected);
}

TEST(Preview, LightsBecomePointsAtTheirCentres) {
    const SceneDesc p = without_distributed_effects(distributed_scene());
    ASSERT_EQ(p.lights.size(), 6u);
    const Vec3d centers[] = {{1, 4, 1.5}, {1, 2, 3}, {9, 8, 7}};
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(std::get<PointLight>(p.lights[i].shape).position, centers[i % 3]);
        EXPECT_FALSE(p.lights[i].visible);
    }
}

TEST(Preview, PhysicalLightsKeepTheirIntensityHeadOn) {
    const SceneDesc p = without_distributed_effects(distributed_scene());
    for (size_t i : {0u, 1u, 2u, 5u}) EXPECT_EQ(p.lights[i].color, (Color{1, 2, 4}));  // no falloff; already a point
    EXPECT_EQ(p.lights[3].color, (Color{6, 12, 24}));                                  // area 2 x 3
    EXPECT_FLOAT_EQ(p.lights[4].color.r, float(4 * pi<double>));                       // pi r^2
}

}  // namespace
}  // namespace drt
