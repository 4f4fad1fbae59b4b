// Every combination of the features that a plan can leave out, on a small picture: the plan keeps just those that are
// there, and what it leaves out does not matter.

#include <gtest/gtest.h>

#include <set>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

enum Feature {
    pixel_filter,
    lens,
    moving_body,
    moving_camera,
    plane,
    texture,
    light_source,
    area_light,
    visible_light,
    specular,
    reflection,
    refraction,
    glossy,
    feature_count
};

struct Combination {
    unsigned bits = 0;
    bool has(Feature f) const { return (bits >> f & 1) != 0; }
};

/// Some features need others: a visible light is a light.
Combination completed(unsigned bits) {
    const auto implies = [&](Feature f, Feature needed) {
        if (bits >> f & 1) bits |= 1u << needed;
    };
    implies(visible_light, area_light);
    implies(area_light, light_source);
    if (!(bits >> light_source & 1)) bits &= ~(1u << specular);
    if (!(bits >> reflection & 1) && !(bits >> refraction & 1)) bits &= ~(1u << glossy);
    return {bits};
}

Features expected_features(Combination c) {
    Features f;
    f.pixel_filter = c.has(pixel_filter);
    f.lens = c.has(lens);
    f.time = c.has(moving_body) || c.has(moving_camera);
    f.moving_camera = c.has(moving_camera);
    f.planes = c.has(plane);
    f.textures = c.has(texture);
    f.lights = c.has(light_source);
    f.light_samples = c.has(area_light);
    f.visible_lights = c.has(visible_light);
    f.specular = c.has(specular);
    f.refraction = c.has(refraction);
    f.scatter = c.has(reflection) || c.has(refraction);
    f.glossy = c.has(glossy);
    f.lobe_lights = c.has(glossy) && c.has(reflection) && c.has(visible_light);
    f.double_precision = true;
    return f;
}

void add_camera_features(SceneDesc& scene, Combination c) {
    Camera& camera = scene.cameras[0];
    camera.shutter.duration = 0.25;
    camera.video_end = 1;
    if (!c.has(pixel_filter)) scene.render.filter.kind = Filter::Kind::point;
    if (c.has(lens)) camera.lens.aperture_radius = 0.1;
    if (c.has(moving_camera)) camera.positions.push_back({0.5, 2, 4});
}

SceneDesc scene_with(Combination c, const std::string& texture_file) {
    SceneDesc scene = simple_scene({0.3, 1.5, 5}, {0, 0.7, 0});
    scene.render.width = 16;
    scene.render.height = 12;
    scene.render.max_depth = 2;
    scene.background = {0.2f, 0.3f, 0.4f};
    scene.textures = {Texture{"pattern", texture_file, Texture::ColorSpace::linear}};
    add_camera_features(scene, c);
    Material ground = shiny({0.6f, 0.5f, 0.4f}, c.has(specular) ? 0.4f : 0.0f);
    Material ball = ground, block = ground;
    if (c.has(texture)) block.texture = "pattern";
    if (c.has(reflection)) ground.reflectance = 0.5;
    if (c.has(refraction)) ball.refraction = 0.8;
    if (c.has(glossy)) ground.reflection_spread_degrees = ball.refraction_spread_degrees = 5;
    if (c.has(plane))
        add(scene, "ground", Plane{}, ground);
    else
        add(scene, "ground", Disc{{0, 0, 0}, {0, 1, 0}, 2.5}, ground);
    add(scene, "ball", sphere({-0.8, 0.7, 0}, 0.7), ball);
    add(scene, "block", Box{{0.9, 0.5, 0.2}, {1, 1, 1}, {}}, block);
    if (c.has(moving_body))
        scene.bodies[1].motion = Motion{Motion::Interpolation::linear, {key(0, {-0.8, 0.7, 0}), key(1, {0, 1.5, 0})}};
    if (c.has(light_source)) scene.lights.push_back(light("sun", PointLight{{3, 5, 4}}, Color(20.0f)));
    if (c.has(area_light)) scene.lights.push_back(light("lamp", lamp({0, 2.5, 0}, 1), Color(3.0f)));
    if (c.has(visible_light)) scene.lights.back().visible = true;
    return scene;
}

void check(Combination c, const std::string& texture_file) {
    const SceneDesc scene = scene_with(c, texture_file);
    PlanOptions options;
    options.precision = PlanOptions::Precision::double_;  // in float the last bits differ (general_plan_test.cpp)
    RenderOptions spp;
    spp.spp = 2;
    const RenderPlan pruned = compile(scene, options);
    EXPECT_EQ(pruned.features, expected_features(c)) << "combination " << c.bits;
    options.general = true;
    EXPECT_LT(largest_difference(resolve(render(pruned, spp).film), resolve(render_scene(scene, options, spp).film)),
              1e-5)
        << "combination " << c.bits;
}

std::set<unsigned> all_combinations() {
    std::set<unsigned> all;
    for (unsigned bits = 0; bits < 1u << feature_count; ++bits) all.insert(completed(bits).bits);
    return all;
}

class FeatureCombinations : public ::testing::TestWithParam<unsigned> {};

// In shares, so that they run side by side.
constexpr unsigned shares = 8;

TEST_P(FeatureCombinations, ThePlanKeepsWhatIsThereAndTheRestDoesNotMatter) {
    const std::string texture_file = write_test_texture(::testing::TempDir());
    unsigned i = 0;
    for (const unsigned bits : all_combinations())
        if (i++ % shares == GetParam()) check({bits}, texture_file);
}

INSTANTIATE_TEST_SUITE_P(All, FeatureCombinations, ::testing::Range(0u, shares));

}  // namespace
}  // namespace drt
