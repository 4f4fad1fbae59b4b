// Lights of every kind and what they cast shadows of.

#include <string>

#include "pictures/scene_kit.h"

namespace drt {
namespace {

using Falloff = Light::Falloff;
using Distribution = SphereLight::Distribution;

SphereLight bulb(const Vec3d& center, double radius, Distribution distribution) {
    return {center, radius, distribution};
}

/// Things that cast shadows onto a floor.
SceneDesc shadow_scene() {
    SceneDesc scene = simple_scene({0, 3, 6}, {0, 0.6, 0});
    add(scene, "floor", Plane{}, shiny({0.7f, 0.7f, 0.7f}, 0.05f, 4));
    add(scene, "ball", sphere({-1.2, 0.8, 0}, 0.7), shiny({0.8f, 0.5f, 0.3f}, 0.4f, 30));
    add(scene, "pillar", Cylinder{{1.1, 0, -0.2}, {1.1, 1.4, -0.2}, 0.35, true}, shiny({0.3f, 0.5f, 0.8f}));
    add(scene, "roof", Rectangle{{-0.3, 1.2, 0.6}, {0.5, 1.2, 0.6}, {0.5, 1.3, 1.4}}, shiny({0.4f, 0.8f, 0.4f}));
    return scene;
}

/// One picture a kind of light, all physical.
PictureCase physical(const std::string& name, const LightShape& shape, const Color& color) {
    PictureCase picture{name, shadow_scene()};
    picture.scene.lights = {light("light", shape, color)};
    return picture;
}

PictureCase legacy(const std::string& name, const LightShape& shape) {
    PictureCase picture{name, shadow_scene()};
    picture.scene.lights = {light("light", shape, {0.7f, 0.6f, 0.5f}, Falloff::none)};
    return picture;
}

PictureCase two_sided_rectangle() {
    RectLight panel;  // stands upright between the bodies
    panel.corner = {-0.3, 0.1, -0.6};
    panel.edge_x = {0.1, 0, 0.9};
    panel.edge_y = {0, 1.5, 0};
    panel.two_sided = true;
    return physical("two-sided rectangle", panel, Color(3.0f));
}

/// The light's plane cuts through the floor and through a body: horizon and grazing light.
PictureCase cut_by_the_horizon() {
    PictureCase picture{"lights cut by the horizon", shadow_scene()};
    picture.scene.lights = {light("ball", bulb({2.2, 0.2, 1}, 0.6, Distribution::uniform), {4, 3, 2}),
                            light("near", bulb({-1.2, 1.75, 0}, 0.2, Distribution::uniform), {2, 3, 4})};
    return picture;
}

/// Visible lights are seen, mirrored and refracted, and cast shadows of their own.
PictureCase visible_lights() {
    PictureCase picture{"visible lights", shadow_scene()};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 3;
    add(scene, "mirror", Rectangle{{-3, 0, -2}, {3, 0, -2}, {3, 3, -2.3}}, mirror(0.6));
    add(scene, "glass", sphere({0.3, 0.4, 1.6}, 0.4), glass(1.4));
    RectLight tilted;
    tilted.corner = {-2.4, 1.9, -0.4};
    tilted.edge_x = {0.9, 0.3, 0};
    tilted.edge_y = {0, 0.3, 0.8};
    RectLight both = tilted;
    both.corner = {1.9, 1.2, 0.2};
    both.two_sided = true;
    scene.lights = {light("lamp", lamp({0.2, 2.2, 0}, 0.9), {3, 2.5f, 2}),
                    light("ball", bulb({2, 0.4, 1}, 0.3, Distribution::uniform), {2, 3, 4}),
                    light("radial", bulb({-0.2, 0.4, 0.7}, 0.25, Distribution::radial), {4, 2, 4}),
                    light("tilted", tilted, {0.5f, 1, 0.5f}),
                    light("both", both, {1, 0.5f, 0.5f}),
                    light("point", PointLight{{0.2, 3.5, 1}}, Color(8.0f))};
    for (Light& l : scene.lights) l.visible = l.name != "point";
    return picture;
}

PictureCase inside_a_light() {
    PictureCase picture{"inside a light", shadow_scene()};
    Light around = light("around", bulb({0, 0, 0}, 30, Distribution::uniform), {0.3f, 0.4f, 0.5f});
    around.visible = true;
    picture.scene.lights = {around, light("lamp", lamp({0, 5, 0}, 2), Color(2.0f))};
    picture.scene.bodies[0].shape = Disc{{0, 0, 0}, {0, 1, 0}, 3};
    picture.scene.render.max_depth = 1;
    picture.scene.materials[1].reflectance = 0.5;
    return picture;
}

/// Seventy-two small lights: 54 with falloff, of which a tree chooses, and 18 without, chosen by power.
PictureCase many_lights() {
    PictureCase picture{"many lights", shadow_scene()};
    picture.reference_spp = 64;
    for (int i = 0; i < 72; ++i) {
        const double x = (i % 8) - 3.5, z = 0.5 * double(i / 8) - 2;
        const Color color{0.02f * float(i % 3), 0.015f, 0.025f * float(i % 2)};
        if (i % 4 == 0)
            picture.scene.lights.push_back(light("rect", lamp({x, 3, z}, 0.4), color * 4.0f));
        else if (i % 4 == 1)
            picture.scene.lights.push_back(light("point", PointLight{{x, 3, z}}, color * 4.0f));
        else
            picture.scene.lights.push_back(
                light("bulb", bulb({x, 3, z}, 0.2, i % 4 == 2 ? Distribution::radial : Distribution::uniform),
                      color * (i % 4 == 2 ? 6.0f : 0.4f), i % 4 == 2 ? Falloff::inverse_square : Falloff::none));
        picture.scene.lights.back().name += std::to_string(i);
    }
    return picture;
}

/// A dozen visible rectangles and a dozen visible spheres of very different power over a dull mirror: chosen by a
/// tree at every hit, seen by the lobes. One light is black.
PictureCase many_visible_lights() {
    PictureCase picture{"many visible lights", shadow_scene()};
    SceneDesc& scene = picture.scene;
    picture.reference_spp = 512;
    picture.rare = 4.8;  // the floor's half of the brightest ball
    scene.render.max_depth = 2;
    scene.materials[0].reflectance = 0.5;
    scene.materials[0].reflection_spread_degrees = 8;
    for (int i = 0; i < 12; ++i) {
        const double x = (i % 4) * 1.3 - 2, z = double(i / 4) * 1.2 - 1.5;
        const float power = i == 7 ? 0.0f : float(1 << (i % 5));
        RectLight rect = lamp({x, 2.6, z}, 0.3);
        rect.two_sided = i % 3 == 0;
        scene.lights.push_back(light("rect" + std::to_string(i), rect, Color{0.5f, 0.4f, 0.2f} * power));
        scene.lights.push_back(light("ball" + std::to_string(i), bulb({x + 0.6, 2.2, z}, 0.1, Distribution::uniform),
                                     Color{0.2f, 0.5f, 0.6f} * power));
    }
    for (Light& l : scene.lights) l.visible = true;
    return picture;
}

/// Lamps at a fraction of their size from what they light: rectangles and parallelograms, one hanging low over the
/// floor, one standing on it, one that shines to both sides.
PictureCase near_rectangles() {
    PictureCase picture{"near rectangles", shadow_scene()};
    picture.reference_spp = 2048;  // the reference samples areas: its noise is large, and far from normal
    const auto rect = [](const Vec3d& corner, const Vec3d& x, const Vec3d& y, bool two_sided) {
        RectLight l;
        l.corner = corner;
        l.edge_x = x;
        l.edge_y = y;
        l.two_sided = two_sided;
        return l;
    };
    picture.scene.lights = {
        light("low", rect({-3, 0.05, 0.8}, {2, 0, 0}, {0.5, 0, 1.5}, false), Color(0.4f)),
        light("lower", rect({0.8, 0.02, 1.0}, {1.5, 0, 0}, {0, 0.01, 1.2}, false), {0.6f, 0.3f, 0.2f}),
        light("wall", rect({-2.5, 0, -1.5}, {5, 0, 0}, {0.3, 2, 0}, true), {0.2f, 0.3f, 0.6f}),
        light("tube", rect({-2, 1.75, 0}, {0.02, 0, 0}, {0, 0, 3}, true), Color(9.0f)),
        light("ceiling", rect({-8, 2.5, -8}, {16, 0, 0}, {0, 0, 16}, false), {0.2f, 0.2f, 0.1f})};
    return picture;
}

/// Dull mirrors of several spreads under visible lights of several sizes: found by light samples and by the lobes.
PictureCase glossy_reflections_of_lights() {
    PictureCase picture{"glossy reflections of visible lights", shadow_scene()};
    SceneDesc& scene = picture.scene;
    picture.reference_spp = 512;
    scene.render.max_depth = 2;
    const double spreads[] = {12, 3, 40, 0};
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        scene.materials[i].reflectance = 0.6;
        scene.materials[i].reflection_spread_degrees = spreads[i % 4];
    }
    scene.materials[2].refraction = 0.3;
    scene.materials[2].refraction_index = 1.3;
    scene.materials[2].refraction_spread_degrees = 5;
    RectLight panel = lamp({0.3, 2.4, -0.6}, 0.8);
    RectLight both = lamp({-2.2, 1.2, -1}, 0.6);
    both.two_sided = true;
    scene.lights = {light("panel", panel, {6, 5, 4}), light("both", both, {2, 6, 3}),
                    light("ball", bulb({1.9, 0.5, 1}, 0.25, Distribution::uniform), {8, 6, 9}),
                    light("radial", bulb({-0.3, 0.3, 1.6}, 0.2, Distribution::radial), {5, 2, 3})};
    for (Light& l : scene.lights) l.visible = true;
    return picture;
}

/// A dull mirror among so many visible lights that a tree chooses, in a visible ball around it all.
PictureCase glossy_reflections_of_many_lights() {
    PictureCase picture = many_visible_lights();
    picture.name = "glossy reflections of many lights";
    SceneDesc& scene = picture.scene;
    scene.bodies[0].shape = Disc{{0, 0, 0}, {0, 1, 0}, 5};
    Light around = light("around", bulb({0, 0, 0}, 30, Distribution::uniform), {0.1f, 0.2f, 0.3f});
    around.visible = true;
    scene.lights.push_back(around);
    for (Material& m : scene.materials) {
        m.reflectance = 0.4;
        m.reflection_spread_degrees = 20;
    }
    return picture;
}

/// A wall parts the brightest from the faintest: lamps of 1e-9 and of 1e9 in one picture.
PictureCase faint_and_bright() {
    PictureCase picture{"faint and bright", shadow_scene()};
    picture.tolerance = 0;  // there is nothing below the faint side
    SceneDesc& scene = picture.scene;
    scene.ambient_light = Color(0.0f);
    scene.bodies[0].shape = Disc{{0, 0, 0}, {0, 1, 0}, 5};
    add(scene, "wall", Box{{0, 5, 0}, {0.1, 10, 40}, {}}, shiny({0.6f, 0.6f, 0.6f}));
    scene.lights = {light("faint", lamp({-1.5, 3, 1}, 0.8), Color{3e-9f, 2e-9f, 1e-9f}),
                    light("bright", lamp({1.5, 3, 1}, 0.8), Color{1e9f, 2e9f, 3e9f})};
    return picture;
}

}  // namespace

std::vector<PictureCase> light_pictures() {
    return {
        physical("point light", PointLight{{1, 3, 2}}, {12, 10, 8}),
        physical("rectangle light", lamp({0.5, 3, 1}, 1.6), {3, 2.5f, 2}),
        physical("uniform sphere light", bulb({1, 2.6, 2}, 0.7, Distribution::uniform), {6, 5, 4}),
        physical("radial sphere light", bulb({1, 2.6, 2}, 0.7, Distribution::radial), {6, 5, 4}),
        two_sided_rectangle(),
        legacy("legacy point light", PointLight{{1, 3, 2}}),
        legacy("legacy rectangle light", lamp({0.5, 3, 1}, 1.6)),
        legacy("legacy uniform sphere light", bulb({1, 2.6, 2}, 0.7, Distribution::uniform)),
        legacy("legacy radial sphere light", bulb({1, 2.6, 2}, 0.7, Distribution::radial)),
        cut_by_the_horizon(),
        visible_lights(),
        inside_a_light(),
        many_lights(),
        many_visible_lights(),
        near_rectangles(),
        glossy_reflections_of_lights(),
        glossy_reflections_of_many_lights(),
        faint_and_bright(),
    };
}

}  // namespace drt
