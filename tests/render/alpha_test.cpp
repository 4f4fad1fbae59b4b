// What a picture covers: bodies, visible lights and a background that is not black.

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

using Precision = PlanOptions::Precision;

class Alpha : public ::testing::TestWithParam<Precision> {
protected:
    Image picture_of(const SceneDesc& scene) const {
        PlanOptions plan;
        plan.precision = GetParam();
        RenderOptions options;
        options.spp = 16;
        return resolve(render_scene(scene, plan, options).film);
    }
};

/// A disc, a ball of air, and a mirror that shows the background, before it.
SceneDesc bodies_before(const Color& background) {
    SceneDesc scene = simple_scene({0, 0, 5}, {0, 0, 0});
    scene.render.width = scene.render.height = 22;
    scene.render.max_depth = 4;
    scene.render.filter = Filter{};
    scene.ambient_light = Color(1.0f);
    scene.background = background;
    Material air = glow("", Color(0.0f)), face = air;
    air.refraction = air.refraction_index = 1;
    face.reflectance = 1;
    add(scene, "disc", Disc{{-1, 0, 0}, {0, 0, 1}, 0.5}, glow("", {0.25f, 0.5f, 1}));
    add(scene, "air", sphere({1, 0, 0}, 0.5), air);
    add(scene, "mirror", Disc{{0, 1, 0}, {0, 0, 1}, 0.5}, face);
    return scene;
}

// Over a picture of the background's colour, the transparent picture is the other one.
TEST_P(Alpha, TransparentPicturesAreLaidOverOthers) {
    const Color background{0.5f, 0.125f, 3};
    SceneDesc scene = bodies_before(background);
    scene.background = background;
    const Image opaque = picture_of(scene);
    scene.render.transparent_background = true;
    const Image transparent = picture_of(scene);
    const std::array<float, 3> back{background.r, background.g, background.b};
    int clear = 0, covered = 0;
    for (size_t i = 0; i < opaque.data.size(); i += 4) {
        ASSERT_EQ(opaque.data[i + 3], 1.0f);
        const float alpha = transparent.data[i + 3];
        for (size_t c = 0; c < 3; ++c) {
            ASSERT_NEAR(transparent.data[i + c] + (1 - alpha) * back[c], opaque.data[i + c], 1e-6) << i;
            if (alpha == 0) {
                ASSERT_EQ(transparent.data[i + c], 0.0f);
            }
        }
        clear += alpha == 0;
        covered += alpha == 1;
    }
    EXPECT_GT(clear, 100);
    EXPECT_GT(covered, 30);
    // Bodies show the background all the same.
    for (const auto& [x, y] : {std::pair(16, 11), std::pair(11, 5)}) {
        EXPECT_EQ(transparent.pixel(x, y)[0], background.r) << x;
        EXPECT_EQ(transparent.pixel(x, y)[3], 1.0f) << x;
    }
}

// Of any colour but black.
TEST_P(Alpha, ABackgroundIsPartOfThePicture) {
    for (const Color& background : {Color(0.5f), Color{0, 0, 1e-9f}, Color(1e9f), Color(0.0f)}) {
        const Image picture = picture_of(bodies_before(background));
        EXPECT_EQ(picture.pixel(0, 0)[2], background.b);
        EXPECT_EQ(picture.pixel(0, 0)[3], background.b > 0 ? 1.0f : 0.0f);
        EXPECT_EQ(picture.pixel(5, 11)[3], 1.0f);
        EXPECT_EQ(picture.pixel(16, 11)[3], 1.0f);
    }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Alpha, ::testing::Values(Precision::single, Precision::double_),
                         [](const auto& test) { return test.param == Precision::single ? "float" : "double"; });

}  // namespace
}  // namespace drt
