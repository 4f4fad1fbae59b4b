// Scenes in which rays find nothing to shade: no bodies at all, or only lights that are seen.

#include <gtest/gtest.h>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

using Precision = PlanOptions::Precision;

class EmptyScene : public ::testing::TestWithParam<Precision> {
protected:
    Image picture_of(const SceneDesc& scene) const {
        PlanOptions plan_options;
        plan_options.precision = GetParam();
        RenderOptions options;
        options.spp = 3;
        return resolve(render_scene(scene, plan_options, options).film);
    }
};

SceneDesc nothing() {
    SceneDesc scene = simple_scene({0, 0, 4}, {0, 0, 0});
    scene.render.width = 19;
    scene.render.height = 11;
    scene.render.filter = Filter{};
    scene.bodies.clear();
    scene.materials.clear();
    scene.lights.clear();
    scene.background = Color(0.25f, 0.5f, 1);
    return scene;
}

void expect_background(const Image& picture) {
    for (size_t i = 0; i < picture.data.size(); i += 4) {
        ASSERT_EQ(picture.data[i], 0.25f);
        ASSERT_EQ(picture.data[i + 1], 0.5f);
        ASSERT_EQ(picture.data[i + 2], 1.0f);
        ASSERT_EQ(picture.data[i + 3], 1.0f);
    }
}

TEST_P(EmptyScene, WithoutBodiesIsBackground) { expect_background(picture_of(nothing())); }

TEST_P(EmptyScene, WithAPointLightIsBackground) {
    SceneDesc scene = nothing();
    Light light;
    light.name = "l";
    light.shape = PointLight{{0, 0, 2}};
    scene.lights.push_back(light);
    expect_background(picture_of(scene));
}

TEST_P(EmptyScene, WithAVisibleLightShowsIt) {
    SceneDesc scene = nothing();
    Light light;
    light.name = "l";
    light.shape = SphereLight{{0, 0, 0}, 3.9};
    light.color = Color(2.0f);
    light.visible = true;
    scene.lights.push_back(light);
    const Image picture = picture_of(scene);
    EXPECT_EQ(picture.pixel(9, 5)[0], 2.0f);
    EXPECT_EQ(picture.pixel(9, 5)[3], 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Precisions, EmptyScene, ::testing::Values(Precision::single, Precision::double_),
                         [](const auto& test) { return test.param == Precision::single ? "float" : "double"; });

}  // namespace
}  // namespace drt
