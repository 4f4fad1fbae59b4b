// Very many lights without falloff: a few are asked at each hit, chosen by power.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "pictures/scene_kit.h"
#include "support/compare.h"
#include "support/render_picture.h"

namespace drt {
namespace {

constexpr double side = 2;

SceneDesc shadows() {
    SceneDesc scene = simple_scene({0, 3, 6}, {0, 0.6, 0});
    add(scene, "floor", Plane{}, shiny({0.7f, 0.7f, 0.7f}, 0.05f, 4));
    add(scene, "ball", sphere({-0.8, 0.8, 0}, 0.7), shiny({0.8f, 0.5f, 0.3f}, 0.4f, 30));
    return scene;
}

/// A square lamp as rows * rows points, which have the lamp's strength together.
SceneDesc lit_by_points(int rows) {
    SceneDesc scene = shadows();
    const Color color = Color(0.8f) * (1.0f / float(rows * rows));
    for (int i = 0; i < rows * rows; ++i) {
        const double x = (i % rows + 0.5) / rows - 0.5, z = (i / rows + 0.5) / rows - 0.5;
        scene.lights.push_back(light("", PointLight{{side * x, 3, side * z}}, color, Light::Falloff::none));
    }
    return scene;
}

SceneDesc lit_by_lamp() {
    SceneDesc scene = shadows();
    scene.lights = {light("lamp", lamp({0, 3, 0}, side), Color(0.8f), Light::Falloff::none)};
    return scene;
}

TEST(MillionLights, TogetherAreOneAreaLight) {
    const auto points = estimate_scene(lit_by_points(1000), {}, 64), area = estimate_scene(lit_by_lamp(), {}, 64);
    const CompareResult result = compare_pictures(points, area);
    EXPECT_TRUE(result.same) << result.report;
}

/// CPU seconds of one thread; the best of several runs, as other programs only ever add to it.
double render_seconds(const SceneDesc& scene) {
    const RenderPlan plan = compile(scene, {});
    RenderOptions options;
    options.spp = 64;
    options.threads = 1;
    double best = 1e30;
    for (int run = 0; run < 5; ++run) {
        const std::clock_t start = std::clock();
        render(plan, options);
        best = std::min(best, double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best;
}

/// What a thousand times as many lights cost is memory that no cache holds; asking all of them would take a thousand
/// times as long. docs/benchmarks.md states the ratio.
TEST(MillionLights, AreNotAskedOneByOne) {
    const double thousand = render_seconds(lit_by_points(32)), million = render_seconds(lit_by_points(1000));
    std::printf("a million lights / a thousand: %.2f\n", million / thousand);
    EXPECT_LT(million, 6 * thousand);
}

}  // namespace
}  // namespace drt
