#include "ball_scene.h"

#include <string>

namespace drt {

namespace {

Light area_light(std::string name, const Vec3d& corner, float radiance) {
    Light l;
    l.name = std::move(name);
    l.shape = RectLight{corner, {3, 0, 0}, {0, 0, 3}, false};  // shines along cross(x, z) = down
    l.color = Color(radiance);
    return l;
}

Material phong(std::string name, const Color& diffuse, float specular, double reflectance, double spread) {
    Material m;
    m.name = std::move(name);
    m.ambient = diffuse;
    m.diffuse = diffuse;
    m.specular = Color(specular);
    m.shininess = 60;
    m.reflectance = reflectance;
    m.reflection_spread_degrees = spread;
    return m;
}

}  // namespace

SceneDesc ball_scene(const BallSceneOptions& o) {
    SceneDesc s;
    s.render.max_depth = o.glossy ? 2 : 0;
    s.ambient_light = Color(0.05f);
    s.background = Color(0.1f, 0.12f, 0.15f);
    s.materials.push_back(phong("table", {0.15f, 0.4f, 0.2f}, 0, 0, 0));
    Body table;
    table.name = "table";
    table.material = "table";
    table.shape = Box{{0, -0.5, 0}, {40, 1, 40}, {}};
    s.bodies.push_back(table);
    int n = 0;
    for (int row = 0; row < 5; ++row)
        for (int i = 0; i <= row; ++i) {
            const float hue = float(n) / 15;
            const std::string name = "ball" + std::to_string(n);
            s.materials.push_back(
                phong(name, {0.2f + 0.6f * hue, 0.3f, 0.8f - 0.6f * hue}, 0.4f, o.glossy ? 0.25 : 0, o.glossy ? 3 : 0));
            Body ball;
            ball.name = name;
            ball.material = name;
            ball.shape = Sphere{{(i - row * 0.5) * 2.05, 1, -row * 1.78}, 1, {0, 1, 0}, {0, 0, 1}};
            if (o.motion && n % 3 == 0) {
                const Vec3d c = std::get<Sphere>(ball.shape).center;
                ball.motion =
                    Motion{Motion::Interpolation::linear, {{0, c, {}, {}}, {0.04, c + Vec3d{0.6, 0, 0.2}, {}, {}}}};
            }
            s.bodies.push_back(ball);
            ++n;
        }
    Body cue;
    cue.name = "cue";
    cue.material = "ball0";
    cue.shape = Sphere{{-0.5, 1, 5}, 1, {0, 1, 0}, {0, 0, 1}};
    s.bodies.push_back(cue);
    s.lights.push_back(area_light("left", {-6, 9, -2}, 12));
    s.lights.push_back(area_light("right", {4, 9, 2}, 9));
    Camera c;
    c.name = "main";
    c.positions = {{0, 7, 14}};
    c.targets = {{0, 0.5, -2}};
    c.fov_degrees_start = 48;
    c.lens.aperture_radius = o.lens ? 0.15 : 0;
    s.cameras.push_back(c);
    return s;
}

}  // namespace drt
