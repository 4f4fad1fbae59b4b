// Shapes, reflection and refraction.

#include <numbers>

#include "pictures/scene_kit.h"

namespace drt {
namespace {

Disc disc(const Vec3d& center, const Vec3d& normal, double radius) { return {center, normal, radius}; }

Box turned_box(const Vec3d& center, const Vec3d& size, double degrees) {
    Box box;
    box.center = center;
    box.size = size;
    box.orientation = quat_from_axis_angle(normalize(Vec3d{0.3, 1, 0.2}), degrees * std::numbers::pi / 180);
    return box;
}

/// Every shape once, on a floor.
void add_shapes(SceneDesc& scene, const Material& like) {
    const auto tinted = [&](const Color& color) {
        Material m = like;
        m.ambient *= color;
        m.diffuse *= color;
        return m;
    };
    add(scene, "floor", Plane{{0, 0, 0}, {0, 3, 0}}, shiny({0.5f, 0.5f, 0.45f}, 0.1f, 5));
    add(scene, "ball", sphere({-2.6, 0.8, 0}, 0.8), tinted({0.9f, 0.3f, 0.2f}));
    add(scene, "box", turned_box({-0.8, 0.7, 0.3}, {1, 0.8, 1.2}, 35), tinted({0.3f, 0.8f, 0.3f}));
    add(scene, "pillar", Cylinder{{0.9, 0, 0}, {1.2, 1.6, -0.2}, 0.45, true}, tinted({0.3f, 0.4f, 0.9f}));
    add(scene, "tube", Cylinder{{2.2, 0.5, 0.2}, {3.2, 0.7, 0.6}, 0.4, false}, tinted({0.9f, 0.8f, 0.2f}));
    add(scene, "triangle", Triangle{{-3.4, 1.6, -1.2}, {-1.8, 1.7, -1.4}, {-2.4, 2.8, -1}}, tinted({0.8f, 0.3f, 0.8f}));
    add(scene, "rectangle", Rectangle{{-1.2, 1.7, -1}, {0, 1.9, -1.2}, {0.2, 2.8, -0.9}}, tinted({0.2f, 0.8f, 0.8f}));
    add(scene, "parallelogram", Parallelogram{{0.6, 2, -0.9}, {1, 0.2, 0}, {0.4, 0.8, 0.2}},
        tinted({0.9f, 0.5f, 0.2f}));
    add(scene, "disc", disc({2.7, 2.2, -0.8}, {-0.3, -0.2, 1}, 0.6), tinted({0.6f, 0.6f, 0.6f}));
}

PictureCase shapes() {
    PictureCase picture{"shapes", simple_scene({0.5, 2.4, 7}, {0, 1.2, 0}, 50)};
    picture.scene.background = {0.05f, 0.1f, 0.2f};
    add_shapes(picture.scene, shiny(Color(0.9f)));
    picture.scene.lights = {light("sun", PointLight{{4, 8, 6}}, {0.5f, 0.45f, 0.4f}, Light::Falloff::none),
                            light("bulb", PointLight{{-3, 4, 4}}, {25, 20, 30})};
    return picture;
}

/// All the shapes in glass that also reflects a little: both sides of open and closed surfaces.
PictureCase glass_shapes() {
    PictureCase picture{"glass shapes", simple_scene({0.5, 2.4, 7}, {0, 1.2, 0}, 50)};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 4;
    scene.background = {0.3f, 0.5f, 0.8f};
    Material m = glass(1.3, 0.7);
    m.reflectance = 0.2;
    add_shapes(scene, m);
    add(scene, "wall", Plane{{0, 0, -4}, {0.2, 0, 1}}, shiny({0.8f, 0.5f, 0.3f}));
    scene.lights = {light("sun", PointLight{{4, 8, 6}}, Color(0.6f), Light::Falloff::none)};
    return picture;
}

/// Nested and overlapping media, total reflection, the camera's eye outside.
PictureCase nested_glass() {
    PictureCase picture{"nested glass", simple_scene({0, 1.4, 6}, {0, 1, 0})};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 7;
    scene.background = {0.2f, 0.3f, 0.4f};
    add(scene, "floor", Plane{}, shiny({0.6f, 0.5f, 0.4f}));
    add(scene, "post", Cylinder{{-0.6, 0, -2.5}, {-0.6, 3, -2.5}, 0.4, true}, shiny({0.9f, 0.2f, 0.1f}));
    Material water = glass(1.33, 0.95), dense = glass(1.8, 0.9);
    dense.reflectance = 0.1;
    add(scene, "outer", sphere({-0.8, 1.1, 0}, 1), water);
    add(scene, "inner", sphere({-0.8, 1.1, 0.1}, 0.6), dense);
    add(scene, "bubble", sphere({-0.8, 1.1, 0.2}, 0.25), glass(1, 1));
    add(scene, "block", turned_box({1.1, 0.9, 0}, {1.2, 1.4, 1}, 25), dense);
    add(scene, "overlap", sphere({1.7, 1.1, 0.4}, 0.6), water);
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return picture;
}

/// Air in glass in water in glass, one body overlapping three: most paths meet total reflection somewhere, and which
/// index is beyond a surface depends on all that the path is inside of.
PictureCase bubbles() {
    PictureCase picture{"bubbles", simple_scene({0.2, 1.2, 4.5}, {0, 1, 0}, 40)};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 10;
    scene.background = {0.4f, 0.5f, 0.7f};
    const auto clear = [](double index) {
        Material m = glass(index, 0.97);
        m.ambient = {0.1f, 0.25f, 0.15f};
        return m;
    };
    add(scene, "floor", Plane{}, shiny({0.8f, 0.3f, 0.2f}));
    add(scene, "block", turned_box({0, 1.1, 0}, {2.4, 1.9, 1.6}, 20), clear(1.7));
    add(scene, "water", sphere({-0.4, 1.1, 0.1}, 0.6), clear(1.33));
    add(scene, "core", sphere({-0.4, 1.1, 0.2}, 0.35), clear(2.2));
    add(scene, "air", sphere({-0.4, 1.1, 0.25}, 0.15), clear(1));
    add(scene, "across", Cylinder{{-0.6, 1.2, 0.4}, {1.6, 1, 0.2}, 0.2, true}, clear(1.1));  // out of the block's side
    Material dull = clear(1);
    dull.refraction_spread_degrees = 5;
    add(scene, "hollow", sphere({0.7, 1.5, 0}, 0.3), dull);
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return picture;
}

PictureCase mirrors() {
    PictureCase picture{"mirrors", simple_scene({0.4, 1.6, 5}, {0, 1, 0}, 55)};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 3;
    scene.background = {0.1f, 0.2f, 0.4f};
    add(scene, "floor", Plane{}, mirror(0.4));
    add(scene, "back", Rectangle{{-3, 0, -2}, {3, 0, -2}, {3, 3, -2.5}}, mirror(0.8));
    add(scene, "ball", sphere({-0.9, 0.8, 0}, 0.8), mirror(0.7));
    add(scene, "box", turned_box({1.2, 0.7, 0.3}, {1, 0.9, 0.8}, 30), mirror(0.5));
    add(scene, "red", sphere({0.3, 0.3, 1.2}, 0.3), shiny({0.9f, 0.1f, 0.1f}));
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return picture;
}

/// Bright panels and dark gaps mirrored in a dull floor and dull balls.
PictureCase glossy_reflection() {
    PictureCase picture{"glossy reflection", simple_scene({0, 2.6, 6}, {0, 0.3, 0})};
    picture.reference_spp = 1024;  // to see a lobe 5 % wider
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 2;
    scene.background = {0.05f, 0.1f, 0.15f};
    add(scene, "floor", Plane{}, mirror(0.6, 10));
    add(scene, "ball", sphere({-1.3, 0.7, 0}, 0.7), mirror(0.7, 3));
    add(scene, "wide", sphere({1.3, 0.7, 0}, 0.7), mirror(0.7, 30));
    add(scene, "post", Cylinder{{0, 0, -1}, {0, 2.2, -1}, 0.35, true}, glow("", {12, 4, 2}));
    add(scene, "left", Rectangle{{-4, 0, -1.5}, {-1.8, 0, -1.5}, {-1.8, 5, -1.5}}, glow("", {6, 6, 5}));
    add(scene, "right", Rectangle{{1.8, 0, -1.5}, {4, 0, -1.5}, {4, 5, -1.5}}, glow("", {3, 5, 7}));
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return picture;
}

PictureCase glossy_refraction() {
    PictureCase picture{"glossy refraction", simple_scene({0, 1.5, 6}, {0, 0.9, 0})};
    picture.reference_spp = 1024;  // to see a lobe 5 % wider
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 3;
    scene.background = {0.5f, 0.6f, 0.8f};
    add(scene, "floor", Plane{}, shiny({0.6f, 0.5f, 0.3f}));
    add(scene, "pane", Rectangle{{-2.6, 0.1, 1}, {-0.4, 0.1, 1.2}, {-0.4, 2, 1}}, glass(1.2, 0.8, 6));
    add(scene, "ball", sphere({1.1, 0.9, 0.4}, 0.9), glass(1.4, 0.9, 4));
    add(scene, "behind", sphere({-1.4, 0.8, -1.4}, 0.8), shiny({0.2f, 0.7f, 0.3f}));
    add(scene, "block", turned_box({0.6, 0.5, -2.4}, {3, 1, 0.6}, 10), shiny({0.9f, 0.2f, 0.2f}));
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return picture;
}

/// The eye is inside a body of glass whose walls reflect totally at most angles.
PictureCase inside_glass() {
    PictureCase picture{"inside glass", simple_scene({0.3, 0.2, 0.5}, {-0.2, 0, -1}, 100)};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 6;
    scene.background = {0.7f, 0.6f, 0.3f};
    Material m = glass(1.5, 0.8, 2);
    m.ambient = {0.5f, 0.2f, 0.6f};
    add(scene, "block", turned_box({0, 0, 0}, {3, 2, 4}, 15), m);
    add(scene, "ball", sphere({-0.4, -0.2, -1}, 0.3), shiny({0.9f, 0.9f, 0.2f}));
    add(scene, "outside", sphere({-2, 0, -6}, 1.5), glow("", {0.1f, 0.9f, 0.2f}));
    return picture;
}

/// The lens lies across the surfaces of nested media, one of them moved by its priority.
PictureCase eye_in_media() {
    PictureCase picture{"eye in media", simple_scene({0.05, 0.1, 1.95}, {-0.2, 0, -1}, 70)};
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 8;
    scene.background = {0.3f, 0.5f, 0.7f};
    scene.cameras[0].lens.aperture_radius = 0.25;
    scene.cameras[0].lens.focus_start = 4;
    add(scene, "pool", Plane{{0, 1, 0}, {0, 1, 0}}, glass(1.2, 0.95));
    add(scene, "block", turned_box({0, 0, 0}, {3, 2, 4}, 15), glass(1.5, 0.95));
    add(scene, "bubble", sphere({0.1, 0.2, 1.8}, 0.3), glass(1, 0.95));
    add(scene, "drop", sphere({0.3, 0.2, 1.6}, 0.2), glass(1.8, 0.95));
    scene.bodies.back().priority = -1;  // the bubble and the block own what they share with it
    add(scene, "ball", sphere({-0.4, -0.2, -1}, 0.3), shiny({0.9f, 0.9f, 0.2f}));
    add(scene, "outside", sphere({-2, 0, -6}, 1.5), glow("", {0.1f, 0.9f, 0.2f}));
    return picture;
}

/// Glass on a table, glass on glass, a label on glass. `overlap`: how far what refracts reaches into what it touches.
SceneDesc touching_scene(double overlap) {
    SceneDesc scene = simple_scene({0.6, 2.4, 5.5}, {0, 0.8, 0});
    scene.render.max_depth = 7;
    scene.background = {0.3f, 0.45f, 0.6f};
    scene.ambient_light = Color(0.5f);
    const double e = overlap;
    Material table = shiny({0.6f, 0.4f, 0.3f});
    table.reflectance = 0.3;
    add(scene, "table", Box{{0, -0.5, 0}, {8, 1, 6}, {}}, table);
    add(scene, "base", Box{{-1, 0.3 - e, 0}, {1.6, 0.6 + 2 * e, 1.4}, {}}, glass(1.3, 0.95));
    add(scene, "top", Cylinder{{-1, 0.6 - 2 * e, 0}, {-1, 1.7, 0}, 0.5, true}, glass(1.6, 0.95));
    add(scene, "block", Box{{1.1, 0.6 - e, 0.2}, {1, 1.2 + 2 * e, 1}, {}}, glass(1.5, 0.95));
    const auto label = [&](const std::string& name, double z) {
        add(scene, name, Rectangle{{0.8, 0.4, z}, {1.4, 0.4, z}, {1.4, 0.8, z}}, shiny({0.9f, 0.8f, 0.1f}));
    };
    label("label", 0.7 + 2 * e);
    if (e > 0) label("label's back", 0.7 - 2 * e);  // against the block's face on either side of it
    scene.lights = {light("sun", PointLight{{3, 6, 5}}, Color(0.7f), Light::Falloff::none)};
    return scene;
}

/// Contact is overlap: the reference, which knows no contact, renders bodies that reach a little into each other.
PictureCase touching() {
    PictureCase picture{"touching", touching_scene(0)};
    picture.reference_scene = touching_scene(2e-5);
    return picture;
}

/// The same under so many lights that a tree chooses: shadow rays, too, leave from where bodies touch.
PictureCase touching_under_many_lights() {
    PictureCase picture = touching();
    picture.name = "touching under many lights";
    for (SceneDesc* scene : {&picture.scene, &*picture.reference_scene}) {
        scene->ambient_light = Color(0.1f);
        for (int i = 0; i < 20; ++i)
            scene->lights.push_back(light("lamp" + std::to_string(i),
                                          lamp({(i % 5) - 2.0, 2.6 + 0.2 * (i % 3), i / 5 * 0.8 - 0.8}, 0.3),
                                          Color{0.5f, 0.4f, 0.3f} * float(1 + i % 4)));
    }
    return picture;
}

}  // namespace

std::vector<PictureCase> surface_pictures() {
    return {shapes(),
            glass_shapes(),
            nested_glass(),
            bubbles(),
            mirrors(),
            glossy_reflection(),
            glossy_refraction(),
            inside_glass(),
            eye_in_media(),
            touching(),
            touching_under_many_lights()};
}

}  // namespace drt
