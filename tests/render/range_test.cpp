// A picture scales with its lights, from the faintest to the brightest.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

using Precision = PlanOptions::Precision;

RenderResult render_with(const SceneDesc& scene, Precision precision, int spp) {
    PlanOptions plan;
    plan.precision = precision;
    RenderOptions options;
    options.spp = spp;
    return render_scene(scene, plan, options);
}

class Range : public ::testing::TestWithParam<Precision> {
protected:
    RenderResult result_of(const SceneDesc& scene, int spp = 16) const { return render_with(scene, GetParam(), spp); }
    Image picture_of(const SceneDesc& scene) const { return resolve(result_of(scene).film); }
};

/// Everything that shines: lights of all kinds and falloffs, some of them seen, ambient light on a texture, a
/// background; and everything that passes light on, by a filter with negative lobes.
SceneDesc all_that_shines(double brightness) {
    const auto scaled = [&](double v) { return Color(float(v * brightness)); };
    SceneDesc scene = simple_scene({0, 2, 6}, {0, 0.5, 0});
    scene.render.width = 33;
    scene.render.height = 25;
    scene.render.max_depth = 3;
    scene.render.filter.kind = Filter::Kind::mitchell;
    scene.render.filter.radius = 2;
    scene.ambient_light = scaled(0.125);
    scene.background = scaled(0.25);
    scene.textures.push_back({"pattern", write_test_texture(::testing::TempDir()), {}});
    Material floor = shiny({0.7f, 0.7f, 0.7f}, 0.3f, 20);
    floor.texture = "pattern";
    add(scene, "floor", Plane{}, floor);
    add(scene, "ball", sphere({-0.8, 0.8, 0}, 0.7), mirror(0.7, 5));
    add(scene, "lens", sphere({0.8, 0.8, 0}, 0.7), glass(1.5, 0.9, 2));
    SphereLight globe;
    globe.center = {0, 0.6, -2};
    globe.radius = 0.3;
    scene.lights = {light("lamp", lamp({0, 3, 0}, 1), scaled(4)), light("bulb", lamp({2, 3, 0}, 1), scaled(0.25)),
                    light("point", PointLight{{-3, 2, 1}}, scaled(2)), light("globe", globe, scaled(16))};
    scene.lights[0].visible = scene.lights[3].visible = true;
    scene.lights[1].falloff = Light::Falloff::none;
    return scene;
}

// By a power of two even to the last bit: no number is rounded otherwise.
TEST_P(Range, ThePictureScalesWithItsLights) {
    const Image one = picture_of(all_that_shines(1));
    for (const int octaves : {-60, -40, -20, -7, 5, 11, 20, 40, 60}) {
        const double brightness = std::exp2(octaves);
        const Image scaled = picture_of(all_that_shines(brightness));
        for (size_t i = 0; i < one.data.size(); ++i)
            ASSERT_EQ(scaled.data[i], i % 4 == 3 ? one.data[i] : float(one.data[i] * brightness))
                << octaves << " octaves, value " << i;
    }
}

// A flat picture has the very value, whatever it is.
TEST_P(Range, ConstantsAreExact) {
    for (const float value : {1e-30f, 1e-13f, 1e-9f, 2e-8f, 1e-7f, 1e-4f, 0.1f, 65.3f, 4321.1f, 1e6f, 1.6e9f, 1e12f,
                              1e30f, std::numeric_limits<float>::max()}) {
        SceneDesc scene = simple_scene({0, 0, 6}, {0, 0, 0});
        scene.background = Color(value);
        scene.ambient_light = Color(value);
        add(scene, "wall", Rectangle{{0, -9, 0}, {9, -9, 0}, {9, 9, 0}}, glow("", Color(1.0f)));
        const RenderResult result = result_of(scene, 3);
        const Image picture = resolve(result.film);
        for (size_t i = 0; i < picture.data.size(); ++i) ASSERT_EQ(picture.data[i], i % 4 == 3 ? 1.0f : value);
        EXPECT_EQ(result.error.rmse, 0);
        EXPECT_EQ(result.counters.film.overflowed.count, 0u);
    }
}

// Lights of 1e-9 and of 1e9 side by side: each half of the floor is as if the other were not there.
TEST_P(Range, FaintAndBrightInOnePicture) {
    const auto floor_under = [](double left, double right) {
        SceneDesc scene = simple_scene({0, 5, 0.01}, {0, 0, 0});
        scene.ambient_light = Color(0.0f);
        add(scene, "floor", Plane{}, matte("", Color(1.0f)));
        add(scene, "wall", Box{{0, 10, 0}, {0.01, 20, 200}, {}}, matte("", Color(0.0f)));
        scene.lights = {light("left", PointLight{{-1, 1, 0}}, Color(float(left))),
                        light("right", PointLight{{1, 1, 0}}, Color(float(right)))};
        return scene;
    };
    const Image both = picture_of(floor_under(1e-9, 1e9)), same = picture_of(floor_under(1, 1));
    for (const int x : {5, 20, 45, 60})
        for (int y = 0; y < both.height; ++y) {
            const double unit = x < 32 ? 1e-9 : 1e9;
            EXPECT_NEAR(both.pixel(x, y)[0] / unit, same.pixel(x, y)[0], 1e-6 * same.pixel(x, y)[0]) << x << ' ' << y;
        }
}

// Ever brighter between mirrors that reflect a thousand times what they receive: cut, and counted, not lost.
TEST_P(Range, BrightMirrorsStayNumbers) {
    for (const Filter::Kind filter : {Filter::Kind::box, Filter::Kind::mitchell})
        for (const int depth : {8, 100, 10000}) {
            SceneDesc scene = simple_scene({0, 0, 5}, {0, 0, 0});
            scene.render.filter.kind = filter;
            scene.render.filter.radius = 1.5;
            scene.render.max_depth = depth;
            Material bright = mirror(1e3);
            bright.diffuse = bright.ambient = {0.6f, 0, 1e-30f};
            for (const double x : {-2.0, 2.0}) {
                add(scene, "low" + std::to_string(x), sphere({x, 0, 0}, 1), bright);
                add(scene, "high" + std::to_string(x), sphere({x, 2, 0}, 1), bright);
            }
            add(scene, "middle", sphere({0, 0, 0}, 1), bright);
            add(scene, "floor", Plane{{0, -1, 0}, {0, 1, 0}}, matte("", Color(0.5f)));
            scene.lights = {light("lamp", lamp({0, 4, 0}, 2), Color(12.0f))};
            const RenderResult result = result_of(scene, 4);
            EXPECT_EQ(result.counters.film.nonfinite.count, 0u) << depth;
            EXPECT_EQ(result.counters.cut_paths > 0, depth > 8) << depth;
            for (const float v : resolve(result.film).data) ASSERT_TRUE(std::isfinite(v));
        }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Range, ::testing::Values(Precision::single, Precision::double_),
                         [](const auto& test) { return test.param == Precision::single ? "float" : "double"; });

}  // namespace
}  // namespace drt
