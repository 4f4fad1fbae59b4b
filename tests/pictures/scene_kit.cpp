#include "pictures/scene_kit.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

namespace drt {

SceneDesc simple_scene(const Vec3d& eye, const Vec3d& target, double fov_degrees) {
    SceneDesc scene;
    scene.render.width = 64;
    scene.render.height = 48;
    scene.render.max_depth = 0;
    scene.render.filter.kind = Filter::Kind::box;
    scene.render.filter.radius = 0.5;
    scene.ambient_light = Color(0.15f);
    Camera camera;
    camera.name = "camera";
    camera.positions = {eye};
    camera.targets = {target};
    camera.fov_degrees_start = fov_degrees;
    camera.shutter.duration = 0;
    scene.cameras = {camera};
    return scene;
}

void add(SceneDesc& scene, const std::string& name, const Shape& shape, Material material) {
    material.name = name;
    scene.materials.push_back(material);
    scene.bodies.push_back(body(name, shape, name));
}

void add_moving(SceneDesc& scene, const std::string& name, const Shape& shape, Material material,
                const Motion& motion) {
    add(scene, name, shape, material);
    scene.bodies.back().motion = motion;
}

Material shiny(const Color& color, float specular, double shininess) {
    Material m;
    m.ambient = m.diffuse = color;
    m.specular = Color(specular);
    m.shininess = shininess;
    return m;
}

Material mirror(double reflectance, double spread_degrees) {
    Material m = shiny({0.1f, 0.08f, 0.05f}, 0.1f);
    m.reflectance = reflectance;
    m.reflection_spread_degrees = spread_degrees;
    return m;
}

Material glass(double index, double refraction, double spread_degrees) {
    Material m = shiny({0.02f, 0.03f, 0.03f}, 0.4f, 60);
    m.refraction = refraction;
    m.refraction_index = index;
    m.refraction_spread_degrees = spread_degrees;
    return m;
}

RectLight lamp(const Vec3d& center, double side) {
    RectLight rect;  // cross(x, z) = -y
    rect.corner = center - Vec3d{side / 2, 0, side / 2};
    rect.edge_x = {side, 0, 0};
    rect.edge_y = {0, 0, side};
    return rect;
}

std::string write_test_texture(const std::string& folder) {
    constexpr int width = 16, height = 8;
    // Tests run side by side and all write this file: none may see another's half.
    const std::string path = folder + "/test_texture.ppm";
    const std::string draft = path + std::to_string(std::random_device{}());
    std::ofstream file(draft, std::ios::binary);
    file << "P6\n" << width << ' ' << height << "\n255\n";
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double u = 2 * std::numbers::pi * (x + 0.5) / width, v = 2 * std::numbers::pi * (y + 0.5) / height;
            for (const double value : {std::sin(u), std::cos(u) * std::sin(v), std::cos(v) + 0.3 * std::sin(2 * u)})
                file << char(int(130 + 90 * value));
        }
    }
    file.close();
    std::filesystem::rename(draft, path);
    return path;
}

}  // namespace drt
