// Lens, shutter, moving bodies and cameras, time mapping, pixel filters; and everything at once.

#include <numbers>

#include "pictures/scene_kit.h"

namespace drt {
namespace {

Quatd turned(const Vec3d& axis, double degrees) {
    return quat_from_axis_angle(normalize(axis), degrees * std::numbers::pi / 180);
}

/// A row of things at several distances.
SceneDesc row() {
    SceneDesc scene = simple_scene({0, 1.6, 5}, {0, 0.7, 0});
    scene.background = {0.3f, 0.4f, 0.6f};
    add(scene, "floor", Plane{}, shiny({0.5f, 0.5f, 0.4f}, 0));
    add(scene, "near", sphere({-1.1, 0.5, 2.2}, 0.5), shiny({0.9f, 0.3f, 0.2f}));
    add(scene, "middle", sphere({0.1, 0.6, 0.2}, 0.6), shiny({0.3f, 0.8f, 0.3f}));
    add(scene, "far", sphere({2, 0.9, -2.5}, 0.9), shiny({0.3f, 0.4f, 0.9f}));
    add(scene, "post", Cylinder{{-1.4, 0, -2}, {-1.4, 2.4, -2}, 0.15, true}, glow("", {2, 2, 1.5f}));
    scene.lights = {light("sun", PointLight{{4, 8, 6}}, Color(0.8f), Light::Falloff::none)};
    return scene;
}

PictureCase lens(const std::string& name, Lens::Distribution distribution, Lens::FocusSurface surface) {
    PictureCase picture{name, row()};
    Lens& l = picture.scene.cameras[0].lens;
    l.aperture_radius = 0.25;
    l.distribution = distribution;
    l.focus_surface = surface;
    if (surface == Lens::FocusSurface::sphere) l.focus_start = 3;
    picture.scene.cameras[0].fov_degrees_start = 60;
    return picture;
}

/// Focus, field of view, roll and both curves on their way, seen through the lens; frame 15 of a second camera.
PictureCase camera_flight() {
    PictureCase picture{"camera flight", row()};
    picture.frame = 15;
    Camera& first = picture.scene.cameras[0];
    first.video_end = 0.4;
    Camera second;
    second.name = "second";
    second.positions = {{-2, 1, 4}, {1, 4, 5}, {2, 1, 4}, {2.5, 2, 3}};
    second.targets = {{0, 0.6, 0}, {0.5, 1, -1}, {0, 0.3, 0}};
    second.up_start = {0.2, 1, 0};
    second.up_end = Vec3d{-0.6, 1, 0.3};
    second.fov_degrees_start = 40;
    second.fov_degrees_end = 75;
    second.lens.aperture_radius = 0.1;
    second.lens.focus_start = 2;
    second.lens.focus_end = 6;
    second.shutter.switch_ratio = 0.5;
    second.shutter.duration = 0.12;
    second.video_start = 0.4;
    second.video_end = 1;
    picture.scene.cameras.push_back(second);
    return picture;
}

/// Bodies on the move: straight, curved, turning, and standing still; trapezoidal shutter of 1/4 s.
SceneDesc moving_row(const std::string& folder) {
    SceneDesc scene = row();
    scene.textures = {Texture{"pattern", write_test_texture(folder), Texture::ColorSpace::linear}};
    scene.lights.push_back(light("bulb", PointLight{{-2, 4, 3}}, Color(10.0f)));
    Motion straight{Motion::Interpolation::linear, {key(0.1, {-1.1, 0.5, 2.2}), key(0.3, {-0.2, 0.9, 2.2})}};
    scene.bodies[1].motion = straight;
    Motion curved{Motion::Interpolation::cubic,
                  {key(-0.2, {1, 0.9, -2.5}), key(0.15, {2, 0.9, -2.5}), key(0.25, {2.3, 2.1, -2.5}),
                   key(0.5, {1.2, 1.8, -2.5})}};
    scene.bodies[3].motion = curved;
    Material pattern = shiny(Color(0.5f));
    pattern.texture = "pattern";
    Sphere ball = sphere({0, 0, 0}, 0.6);  // described elsewhere: the keys say where it is
    add_moving(
        scene, "rolling", ball, pattern,
        {Motion::Interpolation::linear, {key(0, {1.3, 0.6, 1}), turning_key(0.4, {1.3, 0.6, 1}, {0.4, 1, 0.8}, 350)}});
    Box box;
    box.center = {-0.4, 1.9, 0};
    box.size = {1.2, 0.5, 0.5};
    box.orientation = turned({0, 0, 1}, 20);
    Material faces = pattern;
    faces.scale_u = 0.8;
    faces.scale_v = 0.6;
    add_moving(scene, "spinning", box, faces,
               {Motion::Interpolation::linear,
                {key(0.1, {-0.4, 1.9, 0}), key(0.4, {-0.4, 1.7, 0.2}, turned({1, 0.5, 2}, -130))}});
    Camera& camera = scene.cameras[0];
    camera.shutter.duration = 0.25;
    camera.shutter.switch_ratio = 0.6;
    scene.render.fps = 10;
    return scene;
}

PictureCase motion_blur(const std::string& folder) {
    PictureCase picture{"motion blur", moving_row(folder)};
    picture.frame = 1;
    return picture;
}

PictureCase other_shapes_in_motion() {
    PictureCase picture{"other shapes in motion", simple_scene({0, 1.5, 7}, {0, 1.2, 0})};
    SceneDesc& scene = picture.scene;
    scene.background = {0.1f, 0.2f, 0.3f};
    scene.render.fps = 4;  // implicit duration: 1/4 s
    scene.cameras[0].shutter.duration.reset();
    const auto swing = [](const Vec3d& from, const Vec3d& to, const Vec3d& axis, double degrees) {
        return Motion{Motion::Interpolation::linear, {key(0, from), turning_key(0.25, to, axis, degrees)}};
    };
    add_moving(scene, "floor", Plane{{0, 0, -1}, {0, 1, 0}}, shiny({0.6f, 0.6f, 0.5f}),
               swing({0, 0, -1}, {0, 0.2, -1}, {0, 0, 1}, 4));
    add_moving(scene, "triangle", Triangle{{0, 0, 0}, {1.2, 0, 0}, {0.2, 1, 0}}, shiny({0.9f, 0.3f, 0.2f}),
               swing({-2, 1.6, 0}, {-1.8, 2, 0}, {0, 0, 1}, 50));
    add_moving(scene, "rectangle", Rectangle{{0, 0, 0}, {1, 0, 0}, {0.4, 0.7, 0}}, shiny({0.3f, 0.8f, 0.2f}),
               swing({-0.6, 2, 0}, {-0.3, 2, 0.2}, {0, 1, 0}, 80));
    add_moving(scene, "parallelogram", Parallelogram{{0, 0, 0}, {0.8, 0.1, 0}, {0.3, 0.7, 0}},
               shiny({0.3f, 0.3f, 0.9f}), swing({0.8, 2, 0}, {1.2, 2.1, 0}, {1, 1, 0}, 40));
    add_moving(scene, "disc", Disc{{1, 0, 0}, {0.2, 0, 1}, 0.5}, shiny({0.8f, 0.8f, 0.2f}),
               swing({2.3, 1.6, 0}, {2.1, 1.2, 0}, {0, 1, 0.3}, 120));
    add_moving(scene, "stick", Cylinder{{0, 0, 0}, {0, 1.4, 0}, 0.2, true}, shiny({0.8f, 0.3f, 0.8f}),
               swing({-1, 0.8, 0.5}, {-0.8, 0.8, 0.6}, {0, 0, 1}, 70));
    add_moving(scene, "tube", Cylinder{{0, 0, 0}, {0, 0.8, 0}, 0.35, false}, mirror(0.5),
               swing({0.8, 0.8, 0.6}, {0.9, 0.8, 0.6}, {1, 0, 0}, 200));
    scene.render.max_depth = 1;
    scene.lights = {light("lamp", lamp({0.5, 4, 2}, 1.5), Color(4.0f))};
    return picture;
}

/// Scene time runs backwards at 0.4 times the video's speed.
PictureCase reversed_slow_motion(const std::string& folder) {
    PictureCase picture{"reversed slow motion", moving_row(folder)};
    Camera& camera = picture.scene.cameras[0];
    camera.video_start = 0.5;
    camera.video_end = 1.5;
    camera.time_start = 0.4;
    camera.time_end = 0;
    picture.frame = 8;
    return picture;
}

PictureCase moving_camera(const std::string& folder) {
    PictureCase picture{"moving camera", moving_row(folder)};
    Camera& camera = picture.scene.cameras[0];
    camera.motion = Motion{Motion::Interpolation::cubic,
                           {key(0, {0, 1.6, 5.2}), key(0.2, {0.3, 1.7, 5}, turned({0, 1, 0.1}, 8)),
                            turning_key(0.45, {0.1, 1.5, 4.6}, {0.1, 0.2, 1}, 25)}};
    camera.shutter.duration = 0.15;
    picture.frame = 1;
    return picture;
}

/// The same on a keyframed path and through a lens.
PictureCase moving_lens(const std::string& folder) {
    PictureCase picture = moving_camera(folder);
    picture.name = "moving lens";
    picture.scene.cameras[0].lens.aperture_radius = 0.15;
    picture.scene.cameras[0].lens.focus_start = 4;
    picture.scene.cameras[0].fov_degrees_end = 60;
    picture.scene.cameras[0].zoom = Camera::Zoom::focal_length;
    picture.scene.cameras[0].video_end = 0.5;
    return picture;
}

/// The last frame's exposure begins before the camera's end and runs on past it: what goes from start to end stands
/// still there, the bodies keep their pace.
PictureCase past_the_end() {
    PictureCase picture{"exposure past the end", row()};
    SceneDesc& scene = picture.scene;
    scene.render.fps = 10;
    picture.frame = 4;
    scene.bodies[1].motion =
        Motion{Motion::Interpolation::linear, {key(-1, {-1.5, 0.5, 2.2}), key(1, {1.1, 0.9, 2.2})}};
    Camera& camera = scene.cameras[0];
    camera.positions = {{-0.6, 1.6, 5}, {0.2, 2.5, 5.5}, {0.6, 1.4, 4.6}};
    camera.targets = {{0, 0.7, 0}, {0.4, 0.9, 0}};
    camera.up_end = Vec3d{0.3, 1, 0};
    camera.fov_degrees_end = 55;
    camera.lens.aperture_radius = 0.05;
    camera.lens.focus_end = 3.5;  // from the first target's distance
    camera.zoom = Camera::Zoom::image_width;
    camera.video_end = 0.45;
    camera.time_start = 0.9;  // twice as fast as the video, and backwards
    camera.time_end = 0;
    camera.shutter.duration = 0.2;
    return picture;
}

/// Textured bodies of every kind that move by less than their pattern: the texture turns and shifts with them.
PictureCase moving_textures(const std::string& folder) {
    PictureCase picture{"moving textures", row()};
    SceneDesc& scene = picture.scene;
    scene.bodies.clear();
    scene.materials.clear();
    scene.ambient_light = Color(0.6f);
    scene.textures = {Texture{"pattern", write_test_texture(folder), Texture::ColorSpace::linear}};
    Material pattern = shiny(Color(0.5f));
    pattern.texture = "pattern";
    const auto scaled = [&](double u, double v) {
        pattern.scale_u = u;
        pattern.scale_v = v;
        return pattern;
    };
    const auto swing = [](const Vec3d& from, const Vec3d& by, const Vec3d& axis, double degrees) {
        return Motion{Motion::Interpolation::linear, {key(0, from), turning_key(0.2, from + by, axis, degrees)}};
    };
    add_moving(scene, "floor", Plane{}, scaled(9, 7), swing({0.3, 0, 0}, {0.5, 0.1, 0}, {0, 1, 0.05}, 8));
    Box box;
    box.size = {1.2, 0.9, 1};
    add_moving(scene, "box", box, scaled(2, 2.4), swing({-1.6, 1, 0}, {0.1, 0.2, 0}, {1, 1, 0}, 30));
    add_moving(scene, "pillar", Cylinder{{0, 0, 0}, {0, 1.4, 0}, 0.5, true}, scaled(1, 1.5),
               swing({0, 1, 0}, {0, 0.1, 0.2}, {0.3, 1, 0}, -50));
    add_moving(scene, "panel", Rectangle{{0, 0, 0}, {1.1, 0, 0}, {0, 1.3, 0}}, scaled(2.6, 2),
               swing({1.7, 1.2, 0}, {0.2, 0, 0}, {0, 0.4, 1}, 35));
    add_moving(scene, "sheet", Parallelogram{{0, 0, 0}, {1, 0.2, 0}, {0.2, 0.8, 0}}, scaled(2, 2),
               swing({0.6, 2.4, -0.5}, {-0.3, 0, 0}, {0, 1, 0}, 25));
    scene.cameras[0].shutter.duration = 0.2;
    scene.cameras[0].shutter.switch_ratio = 0.3;
    picture.tolerance = 2e-3;
    return picture;
}

/// Nothing but edges, one picture a filter.
PictureCase filter(const std::string& name, const Filter& f) {
    PictureCase picture{name, row()};
    picture.scene.render.filter = f;
    picture.scene.lights.clear();
    for (Material& m : picture.scene.materials) m.ambient = m.ambient * 4.0f;
    if (f.kind == Filter::Kind::mitchell) picture.reference_spp = 1024;  // negative weights are noisy
    return picture;
}

/// Every effect at once.
PictureCase everything(const std::string& folder) {
    PictureCase picture{"everything", moving_row(folder)};
    picture.frame = 1;
    SceneDesc& scene = picture.scene;
    scene.render.width = 48;
    scene.render.height = 36;
    scene.render.filter = Filter{};
    scene.render.max_depth = 3;
    scene.cameras[0].lens.aperture_radius = 0.08;
    scene.cameras[0].shutter.duration = 0.1;
    for (Material& m : scene.materials) {
        if (m.name == "floor") m.reflectance = 0.3, m.reflection_spread_degrees = 4;
        if (m.name == "middle") m.refraction = 0.8, m.refraction_index = 1.3, m.refraction_spread_degrees = 2;
        if (m.name == "far") m.reflectance = 0.5;
    }
    Light lamp_light = light("lamp", lamp({1, 3.5, 2}, 1.2), {3, 2.5f, 2});
    lamp_light.visible = true;
    scene.lights.push_back(lamp_light);
    SphereLight bulb;
    bulb.center = {-2.5, 3, 1};
    bulb.radius = 0.5;
    bulb.distribution = SphereLight::Distribution::radial;
    scene.lights.push_back(light("legacy", bulb, Color(0.3f), Light::Falloff::none));
    return picture;
}

}  // namespace

std::vector<PictureCase> camera_pictures(const std::string& folder) {
    using Distribution = Lens::Distribution;
    using Focus = Lens::FocusSurface;
    using Kind = Filter::Kind;
    return {
        lens("uniform lens, plane of focus", Distribution::uniform, Focus::plane),
        lens("radial lens, sphere of focus", Distribution::radial, Focus::sphere),
        lens("uniform lens, sphere of focus", Distribution::uniform, Focus::sphere),
        camera_flight(),
        motion_blur(folder),
        other_shapes_in_motion(),
        reversed_slow_motion(folder),
        moving_camera(folder),
        moving_lens(folder),
        past_the_end(),
        moving_textures(folder),
        filter("point filter", {Kind::point, 1.5, 0.5}),
        filter("wide box filter", {Kind::box, 1, 0.5}),
        filter("triangle filter", {Kind::triangle, 1, 0.5}),
        filter("gaussian filter", {Kind::gaussian, 1.5, 0.5}),
        filter("legacy gaussian filter", {Kind::gaussian, 0.5, 1 / 3.0}),
        filter("blackman-harris filter", {Kind::blackman_harris, 1.5, 0.5}),
        filter("mitchell filter", {Kind::mitchell, 2, 0.5}),
        everything(folder),
    };
}

}  // namespace drt
