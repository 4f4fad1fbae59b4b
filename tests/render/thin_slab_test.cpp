// A sheet of glass a millionth thick, a thousand away (numerics.md G9): both of its faces must be met, by every ray.

#include <gtest/gtest.h>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

constexpr Color behind{0.2f, 0.4f, 0.6f};

SceneDesc sheet(const Quatd& orientation, double refraction, double index) {
    SceneDesc scene = simple_scene({0, 0, 0}, {0, 0, -1}, 60);
    scene.background = behind;
    scene.render.max_depth = 4;
    Material material = glow("", Color(0.0f));
    material.refraction = refraction;
    material.refraction_index = index;
    add(scene, "sheet", Box{{0, 0, -1000}, {1e4, 1e4, 1e-6}, orientation}, material);
    return scene;
}

/// Every pixel, whatever its rays' angles, shows what is behind times `transmitted`.
void expect_transmits(const SceneDesc& scene, double transmitted) {
    RenderOptions options;
    options.spp = 8;
    const RenderResult result = render_scene(scene, {}, options);
    Image expected = resolve(result.film);
    for (size_t i = 0; i < expected.data.size(); ++i)
        expected.data[i] = i % 4 == 3 ? 1 : float(transmitted) * (&behind.r)[i % 4];
    EXPECT_LT(largest_difference(resolve(result.film), expected), 1e-6);
}

const Quatd tilts[] = {Quatd{}, quat_from_axis_angle(Vec3d{1, 0, 0}, radians(50.0)),
                       quat_from_axis_angle(normalize(Vec3d{0.3, 1, 0.2}), radians(-35.0))};

TEST(ThinSheet, OfAirIsInvisible) {
    for (const Quatd& tilt : tilts) expect_transmits(sheet(tilt, 1, 1), 1);
}

TEST(ThinSheet, OfGlassLetsRaysGoOnAsTheyCame) {
    for (const Quatd& tilt : tilts) expect_transmits(sheet(tilt, 1, 1.5), 1);
}

// Each face takes a half: a ray that slipped through one of them would bring twice as much.
TEST(ThinSheet, LosesNoFace) {
    for (const Quatd& tilt : tilts)
        for (const double index : {1.0, 1.5}) expect_transmits(sheet(tilt, 0.5, index), 0.25);
}

}  // namespace
}  // namespace drt
