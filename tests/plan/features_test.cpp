// What a scene needs: each feature is there when the scene asks for it, and only then.

#include "drt/plan/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "drt/light/light_choice.h"
#include "plan_parts.h"

namespace drt {
namespace {

using test::scene_with;

SceneDesc plain() { return scene_with(sphere({0, 0, -5}, 1)); }

Features features(const SceneDesc& s) { return compile(s, {}).features; }

TEST(Features, APlainSceneNeedsNone) { EXPECT_EQ(features(plain()), Features{}); }

struct Toggle {
    const char* name;
    std::function<void(SceneDesc&)> change;
    std::vector<bool Features::*> expected;
};

const auto point_light = [](SceneDesc& s) { s.lights = {light("l", PointLight{{0, 5, 0}}, Color(1.0f))}; };
const auto moving = [](SceneDesc& s) {
    s.bodies[0].motion = Motion{Motion::Interpolation::linear, {key(0, {0, 0, -5}), key(1, {1, 0, -5})}};
};

const std::vector<Toggle> toggles{
    {"filter", [](SceneDesc& s) { s.render.filter.kind = Filter::Kind::box; }, {&Features::pixel_filter}},
    {"lens", [](SceneDesc& s) { s.cameras[0].lens.aperture_radius = 0.1; }, {&Features::lens}},
    {"motion", moving, {&Features::time}},
    {"motion with an instantaneous shutter",
     [](SceneDesc& s) {
         moving(s);
         s.cameras[0].shutter.duration = 0.0;
     },
     {}},
    {"motion that is over",
     [](SceneDesc& s) {
         moving(s);
         s.bodies[0].motion->keys[0].time = -1;
         s.bodies[0].motion->keys[1].time = -0.5;
     },
     {}},
    {"moving camera",
     [](SceneDesc& s) {
         s.cameras[0].positions = {{0, 0, 0}, {1, 0, 0}};
         s.cameras[0].video_end = 1;
     },
     {&Features::time, &Features::moving_camera}},
    {"zooming camera",
     [](SceneDesc& s) {
         s.cameras[0].fov_degrees_end = 50;
         s.cameras[0].video_end = 1;
     },
     {&Features::time, &Features::moving_camera}},
    {"plane",
     [](SceneDesc& s) {
         s.bodies.push_back(body("p", Plane{{0, -2, 0}}, "grey"));
     },
     {&Features::planes}},
    {"point light", point_light, {&Features::lights}},
    {"black light", [](SceneDesc& s) { s.lights = {light("l", PointLight{}, Color(0.0f))}; }, {}},
    {"area light",
     [](SceneDesc& s) {
         s.lights = {light("l", SphereLight{{0, 5, 0}, 1}, Color(1.0f))};
     },
     {&Features::lights, &Features::light_samples}},
    {"visible light",
     [](SceneDesc& s) {
         s.lights = {light("l", SphereLight{{0, 5, 0}, 1}, Color(1.0f))};
         s.lights[0].visible = true;
     },
     {&Features::lights, &Features::light_samples, &Features::visible_lights}},
    {"specular without light", [](SceneDesc& s) { s.materials[0].specular = Color(1.0f); }, {}},
    {"specular",
     [](SceneDesc& s) {
         point_light(s);
         s.materials[0].specular = Color(1.0f);
     },
     {&Features::lights, &Features::specular}},
    {"mirror", [](SceneDesc& s) { s.materials[0].reflectance = 0.5; }, {&Features::scatter}},
    {"mirror at depth 0",
     [](SceneDesc& s) {
         s.materials[0].reflectance = 0.5;
         s.render.max_depth = 0;
     },
     {}},
    {"glossy mirror and visible light",
     [](SceneDesc& s) {
         s.materials[0].reflectance = 0.5;
         s.materials[0].reflection_spread_degrees = 3;
         s.lights = {light("l", SphereLight{{0, 5, 0}, 1}, Color(1.0f))};
         s.lights[0].visible = true;
     },
     {&Features::scatter, &Features::glossy, &Features::lights, &Features::light_samples, &Features::visible_lights,
      &Features::lobe_lights}},
    {"glossy mirror",
     [](SceneDesc& s) {
         s.materials[0].reflectance = 0.5;
         s.materials[0].reflection_spread_degrees = 3;
     },
     {&Features::scatter, &Features::glossy}},
    {"spread without reflection", [](SceneDesc& s) { s.materials[0].reflection_spread_degrees = 3; }, {}},
    {"glass", [](SceneDesc& s) { s.materials[0].refraction = 0.5; }, {&Features::scatter, &Features::refraction}},
    {"mirror that nobody wears",
     [](SceneDesc& s) {
         s.materials.push_back(matte("unused", Color(0.0f)));
         s.materials[1].reflectance = 1;
     },
     {}},
};

TEST(Features, EachIsThereWhenAskedForAndNoneElse) {
    for (const Toggle& t : toggles) {
        SCOPED_TRACE(t.name);
        SceneDesc s = plain();
        t.change(s);
        Features expected;
        for (const auto member : t.expected) expected.*member = true;
        EXPECT_EQ(features(s), expected);
    }
}

TEST(Features, TheExplanationNamesEachDecisionAndItsReason) {
    SceneDesc s = plain();
    s.cameras[0].lens.aperture_radius = 0.25;
    const Explanation e = compile(s, {}).explanation;
    const auto find = [&](const std::string& what) {
        const auto it = std::find_if(e.begin(), e.end(), [&](const Decision& d) { return d.what == what; });
        EXPECT_NE(it, e.end()) << what;
        return it == e.end() ? Decision{} : *it;
    };
    EXPECT_TRUE(find("lens").kept);
    EXPECT_EQ(find("lens").why, "aperture radius 0.25");
    EXPECT_FALSE(find("time").kept);
    EXPECT_EQ(find("time").why, "nothing moves while the shutter is open");
    EXPECT_FALSE(find("scatter").kept);
    EXPECT_EQ(find("double precision").why, "float is exact enough for every body and pixel");
    for (const Decision& d : e) EXPECT_FALSE(d.why.empty()) << d.what;
}

TEST(Features, TheGeneralPlanKeepsEverything) {
    PlanOptions options;
    options.general = true;
    const RenderPlan plan = compile(plain(), options);
    Features expected = plan.features;
    expected.pixel_filter = expected.lens = expected.time = expected.moving_camera = expected.planes = true;
    expected.textures = expected.visible_lights = expected.lights = expected.light_samples = true;
    expected.specular = expected.scatter = expected.refraction = expected.glossy = true;
    EXPECT_EQ(plan.features, expected);
    EXPECT_FALSE(plan.features.double_precision);
}

// ---- the world
// -------------------------------------------------------------------------------------------------------

const World<float>& world(const RenderPlan& p) { return *std::get<std::unique_ptr<World<float>>>(p.world); }

TEST(Plan, BodiesKeepTheirMaterialsAndLightsTheirBodiesWhenSorted) {
    SceneDesc s = test::empty_scene();
    s.materials.push_back(matte("red", Color{1, 0, 0}));
    s.bodies = {body("plane", Plane{{0, -2, 0}}, "red"), body("box", Box{{0, 0, -5}, {1, 1, 1}, {}}, "grey"),
                body("ball", sphere({3, 0, -5}, 1), "red")};
    s.lights = {light("bulb", SphereLight{{0, 5, 0}, 0.5}, Color(2.0f))};
    s.lights[0].visible = true;
    const RenderPlan plan = compile(s, {});
    const World<float>& w = world(plan);
    ASSERT_EQ(w.bodies.body_count(), 4);
    EXPECT_EQ(w.body_material, (std::vector<int>{1, -1, 0, 1}));  // ball, bulb, box, plane
    EXPECT_EQ(w.body_emitter, (std::vector<int>{-1, 0, -1, -1}));
    EXPECT_EQ(w.lights.spheres[0].body, 1);
    EXPECT_EQ(w.bodies.centers[0], (Vec3f{3, 0, -5}));
    EXPECT_EQ(w.bodies.plane_group.first, 3);
}

TEST(Plan, ABodyThatKeepsItsTurnedPoseIsPutThere) {
    SceneDesc s = scene_with(Box{{9, 9, 9}, {1, 2, 4}, {}});
    s.bodies[0].motion =
        Motion{Motion::Interpolation::linear, {key(0, {0, 0, -5}, quat_from_axis_angle({0, 0, 1}, pi<double> / 2))}};
    const RenderPlan plan = compile(s, {});
    const World<float>& w = world(plan);
    EXPECT_FALSE(plan.features.time);
    EXPECT_EQ(w.bodies.centers[0], (Vec3f{0, 0, -5}));
    EXPECT_NEAR(w.bodies.boxes[0].ax.y, 1, 1e-6);
    EXPECT_TRUE(w.bodies.motions.empty());
}

TEST(Plan, ManyLightsWithoutFalloffAreChosenByPower) {
    SceneDesc s = plain();
    const auto add = [&](double power) {
        s.lights.push_back(light("l", PointLight{{0, 5, 0}}, Color(float(power)), Light::Falloff::none));
    };
    for (int i = 0; i < few_lights; ++i) add(1);
    EXPECT_EQ(world(compile(s, {})).lights.asked.size(), size_t(few_lights));
    add(few_lights);
    const RenderPlan plan = compile(s, {});
    const auto& lights = world(plan).lights;
    EXPECT_TRUE(lights.asked.empty());
    EXPECT_TRUE(lights.tree.empty());
    ASSERT_EQ(lights.plain.lights.size(), size_t(few_lights) + 1);
    EXPECT_NEAR(probability(lights.plain.by_power, few_lights), 0.5, 1e-6);
}

TEST(Plan, ManyLightsWithFalloffOfAnyKindGetATree) {
    SceneDesc s = plain();
    for (int i = 0; i < few_lights; ++i) {
        if (i % 2 == 0)
            s.lights.push_back(light("l", PointLight{{0, 5, 0}}, Color(1.0f)));
        else
            s.lights.push_back(light("l", SphereLight{{0, 5, 0}, 1}, Color(1.0f)));
    }
    s.lights.push_back(light("plain", PointLight{{0, 5, 0}}, Color(1.0f), Light::Falloff::none));
    EXPECT_FALSE(compile(s, {}).features.light_tree);
    s.lights.push_back(light("one more", PointLight{{0, 5, 0}}, Color(1.0f)));
    const RenderPlan plan = compile(s, {});
    EXPECT_TRUE(plan.features.light_tree);
    EXPECT_EQ(world(plan).lights.asked, std::vector<LightId>{light_id::pack(LightKind::point, few_lights / 2)});
    EXPECT_FALSE(world(plan).lights.tree.empty());
}

TEST(Plan, TheMediaStackHoldsAsManyAsRefract) {
    SceneDesc s = plain();
    s.materials.push_back(matte("glass", Color(0.0f)));
    s.materials[1].refraction = 1;
    EXPECT_EQ(world(compile(s, {})).sampling.media_capacity, 0);
    for (int i = 1; i <= 3; ++i) s.bodies.push_back(body("ball", sphere({4.0 * i, 0, -5}, 1), "glass"));
    EXPECT_EQ(world(compile(s, {})).sampling.media_capacity, 3);
}

}  // namespace
}  // namespace drt
