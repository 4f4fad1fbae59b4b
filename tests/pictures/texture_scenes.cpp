// Textures on every shape that carries one.

#include <numbers>

#include "pictures/scene_kit.h"

namespace drt {
namespace {

Material textured(double scale_u, double scale_v) {
    Material m = shiny(Color(0.5f), 0.2f);
    m.texture = "pattern";
    m.scale_u = scale_u;
    m.scale_v = scale_v;
    return m;
}

SceneDesc textured_scene(const std::string& folder, Texture::ColorSpace color_space) {
    SceneDesc scene = simple_scene({0.4, 2.2, 6}, {0, 0.9, 0}, 48);
    scene.ambient_light = Color(0.4f);
    scene.textures = {Texture{"pattern", write_test_texture(folder), color_space}};
    scene.lights = {light("sun", PointLight{{4, 8, 6}}, Color(0.7f), Light::Falloff::none)};
    return scene;
}

PictureCase flat_textures(const std::string& folder) {
    PictureCase picture{"textures on flat shapes", textured_scene(folder, Texture::ColorSpace::linear)};
    picture.tolerance = 1.5e-3;
    SceneDesc& scene = picture.scene;
    add(scene, "floor", Plane{{0.3, 0, 0.2}, {0, 1, 0}}, textured(10, 8));
    add(scene, "wall", Plane{{0, 1, -3}, {0.3, 0.1, 1}}, textured(12, 10));
    add(scene, "rectangle", Rectangle{{-2.6, 0.2, 0}, {-0.8, 0.1, 0.4}, {-0.9, 1.9, 0.2}}, textured(5, 4));
    add(scene, "parallelogram", Parallelogram{{-0.4, 0.3, 0.4}, {1, 0.2, 0}, {0.5, 1.4, 0}}, textured(3, 5));
    Box box;
    box.center = {2, 0.8, 0};
    box.size = {1.2, 1.4, 1};
    box.orientation = quat_from_axis_angle(normalize(Vec3d{0.2, 1, 0.1}), 0.7);
    add(scene, "box", box, textured(3.4, 4));
    return picture;
}

PictureCase round_textures(const std::string& folder) {
    PictureCase picture{"textures on round shapes", textured_scene(folder, Texture::ColorSpace::automatic)};
    picture.tolerance = 1.5e-3;
    SceneDesc& scene = picture.scene;
    scene.render.max_depth = 1;
    add(scene, "floor", Plane{}, mirror(0.4));
    Sphere ball = sphere({-1.7, 0.95, 0}, 0.9);
    ball.pole = {0.3, 2, 0.4};
    ball.meridian = {1, 0.2, 1};
    add(scene, "ball", ball, textured(1, 1));
    add(scene, "pillar", Cylinder{{0.1, 0, 0}, {0.4, 1.5, 0.3}, 0.6, true}, textured(1, 1.5));
    add(scene, "tube", Cylinder{{2.2, 1.4, -0.6}, {1.8, 0.5, 0.8}, 0.5, false}, textured(0.8, 1));
    return picture;
}

}  // namespace

std::vector<PictureCase> texture_pictures(const std::string& folder) {
    return {flat_textures(folder), round_textures(folder)};
}

}  // namespace drt
