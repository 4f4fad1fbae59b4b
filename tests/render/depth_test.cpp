// Long paths: mirrors facing each other, shells within shells.

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

/// Between two mirrors whose faces glow: sum over k of 0.99^k, to depth 1e4.
TEST(Depth, TenThousandReflections) {
    SceneDesc scene = simple_scene({0, 0, 0}, {0, 0, -1}, 1);
    scene.render.width = scene.render.height = 16;
    scene.render.max_depth = 10000;
    scene.ambient_light = Color(1.0f);
    Material face = glow("", Color(1.0f));
    face.reflectance = 0.99;
    add(scene, "front", Plane{{0, 0, -1}, {0, 0, 1}}, face);
    add(scene, "back", Plane{{0, 0, 1}, {0, 0, -1}}, face);
    const PictureEstimate picture = estimate_scene(scene, {}, 16);
    double mean = 0, variance = 0;
    for (size_t i = 0; i < picture.mean.size(); ++i) {
        mean += picture.mean[i].r / double(picture.mean.size());
        variance += picture.variance[i].r / double(picture.mean.size() * picture.mean.size());
    }
    // Russian roulette is the only noise: it must not be a bias.
    const double truth = (1 - std::pow(0.99, 10001)) / (1 - 0.99);
    EXPECT_GT(variance, 0);
    EXPECT_NEAR(mean, truth, 4 * std::sqrt(variance) + 1e-4 * truth);
}

SceneDesc behind_glass() {
    SceneDesc scene = simple_scene({0, 0, 6}, {0, 0, 0});
    scene.background = {0.2f, 0.4f, 0.6f};
    scene.render.max_depth = 250;
    add(scene, "near", sphere({-0.5, 0, -3}, 0.8), glow("", {5, 2, 1}));
    add(scene, "box", Box{{0.8, 0.3, -4}, {1, 1, 1}, {}}, glow("", {1, 4, 2}));
    return scene;
}

SceneDesc with_shells(SceneDesc scene, int count) {
    Material air = glow("", Color(0.0f));
    air.refraction = 1;
    air.refraction_index = 1;
    for (int i = 0; i < count; ++i) add(scene, "shell" + std::to_string(i), sphere({0, 0, 0}, 1 + 0.02 * i), air);
    return scene;
}

/// Without alpha: even a shell of air is a body and covers the background.
Image picture_of(const SceneDesc& scene, PlanOptions::Precision precision) {
    PlanOptions plan;
    plan.precision = precision;
    RenderOptions options;
    options.spp = 4;
    const RenderResult result = render_scene(scene, plan, options);
    EXPECT_EQ(result.counters.media_overflows, 0u);
    EXPECT_EQ(result.counters.film.nonfinite.count, 0u);
    Image picture = resolve(result.film);
    for (size_t i = 3; i < picture.data.size(); i += 4) picture.data[i] = 1;
    return picture;
}

// Bodies of air in air are not there, however many; each is crossed twice.
TEST(Depth, ShellsOfAirAreInvisible) {
    const SceneDesc bare = behind_glass();
    using Precision = PlanOptions::Precision;
    for (const int shells : {1, 50}) {
        const SceneDesc shelled = with_shells(bare, shells);
        EXPECT_LT(largest_difference(picture_of(bare, Precision::double_), picture_of(shelled, Precision::double_)),
                  1e-6)
            << shells;
        // In float a hundred surfaces turn a ray by some 1e-6: only samples at edges may change.
        const Image a = picture_of(bare, Precision::single), b = picture_of(shelled, Precision::single);
        int different = 0;
        for (size_t i = 0; i < a.data.size(); ++i) different += std::abs(a.data[i] - b.data[i]) > 1e-5;
        EXPECT_LE(different, int(a.data.size()) / 500) << shells;
    }
}

// More bodies within each other than a path can remember: said before rendering, with the place, where that is known
// ...
TEST(Depth, TooManyMediaAreAnError) {
    EXPECT_NO_THROW(compile(with_shells(behind_glass(), 64), {}));
    try {
        compile(with_shells(behind_glass(), 65), {});
        FAIL() << "compiled";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::scene);
        EXPECT_NE(std::string(e.what()).find("64"), std::string::npos) << e.what();
    }
}

// ... and counted, not run over, where only rays find it: bars that overlap, but not in anyone's middle.
TEST(Depth, TooManyMediaAreReported) {
    SceneDesc scene = behind_glass();
    Material air = glow("", Color(0.0f));
    air.refraction = 1;
    air.refraction_index = 1;
    for (int i = 0; i < 80; ++i) {
        const double angle = 2 * pi<double> * i / 80;
        Box bar{Vec3d{std::cos(angle), std::sin(angle), 0} * 1.4, {3, 0.4, 0.4}, {}};
        bar.orientation = quat_from_axis_angle(Vec3d{0, 0, 1}, angle);
        add(scene, "bar" + std::to_string(i), bar, air);
    }
    RenderOptions options;
    options.spp = 1;
    const RenderResult result = render_scene(scene, {}, options);
    EXPECT_GT(result.counters.media_overflows, 0u);
    EXPECT_EQ(result.counters.film.nonfinite.count, 0u);
}

}  // namespace
}  // namespace drt
