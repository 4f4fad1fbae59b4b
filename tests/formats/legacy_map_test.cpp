// What every element and attribute means in SceneDesc.
#include <gtest/gtest.h>

#include <cmath>

#include "drt/base/constants.h"
#include "drt/formats/legacy_map.h"
#include "formats/legacy_fixture.h"

namespace drt {
namespace {

using legacy_test::camera;
using legacy_test::read;
using legacy_test::says;

SceneDesc scene(const std::string& text, const LegacyOptions& o = {}) { return read(text, o).scene; }

TEST(LegacySettings, ProductOfPrimaryCountsIsSpp) {
    const auto spp = [](const std::string& counts) {
        return scene("settings S { " + counts + " }" + camera).render.spp;
    };
    EXPECT_EQ(spp(""), 1);
    EXPECT_EQ(spp("blur_samples 32"), 32);
    EXPECT_EQ(spp("dof_samples 18 blur_samples 0"), 18);
    EXPECT_EQ(spp("interpolate_samples 3"), 9);
    EXPECT_EQ(spp("interpolate_samples 3 dof_samples 2 blur_samples 5.0"), 90);
    EXPECT_EQ(spp("soft_shadow_samples 8 diffuse_reflection_samples 8 diffuse_refraction_samples 8"), 1);
    EXPECT_EQ(spp("interpolate_samples 1000000 dof_samples 1000000"), 1 << 20);
}

TEST(LegacySettings, PlainValues) {
    const SceneDesc s =
        scene("settings S { width 800 height 600 fps 12.5 recursion 7 interpolate_samples 4 }" + camera);
    EXPECT_EQ(s.render.width, 800);
    EXPECT_EQ(s.render.height, 600);
    EXPECT_EQ(s.render.fps, 12.5);
    EXPECT_EQ(s.render.max_depth, 7);
    EXPECT_EQ(s.render.filter, (Filter{Filter::Kind::gaussian, 0.5, 1.0 / 3}));
}

TEST(LegacySettings, NoneAtAllMeansDefaultsAndSaysSo) {
    const SceneRead r = read(camera);
    EXPECT_EQ(r.scene.render.width, 640);
    EXPECT_EQ(r.scene.render.fps, 25);
    EXPECT_EQ(r.scene.render.max_depth, 3);
    EXPECT_TRUE(says(r, "default used: settings width = 640")) << legacy_test::notes_of(r);
}

TEST(LegacySettings, MinusOneIsTheDefault) {
    const SceneRead r = read("settings S { width -1 fps -1 blur_samples 3 blur_duration -1 recursion -1 }" + camera);
    EXPECT_EQ(r.scene.render.width, 640);
    EXPECT_EQ(r.scene.render.fps, 25);
    EXPECT_EQ(r.scene.render.max_depth, 3);
    EXPECT_EQ(r.scene.cameras[0].shutter.duration, std::nullopt);
    EXPECT_TRUE(says(r, "default used: settings width = 640 (S)"));
}

TEST(LegacySettings, ShutterAndLensGoToEveryCamera) {
    const SceneDesc s = scene(
        "settings S { blur_samples 4 blur_duration 0.25 blur_switch_ratio 0.5 dof_samples 9 dof_c 0.35 }"
        "camera A { video_start 0 video_end 1 } camera B { video_start 1 }");
    for (const Camera& c : s.cameras) {
        EXPECT_EQ(c.shutter, (Shutter{0.25, 0.5}));
        EXPECT_EQ(c.lens, (Lens{0.35, {}, {}, Lens::Distribution::radial, Lens::FocusSurface::sphere}));
    }
}

TEST(LegacySettings, CountOfZeroTurnsItsEffectOff) {
    const std::string body =
        "phong_info P { diffuse_reflection 0.1 diffuse_refraction 0.2 } material_phong M { phong_info P }"
        "light_rect R { position { 0 5 0 } x { 2 0 0 } y { 0 0 4 } } light_bulb B { position { 1 2 3 } radius 2 }" +
        camera;
    const SceneDesc on = scene("settings S { blur_samples 1 dof_c 1 }" + body);
    EXPECT_EQ(on.cameras[0].shutter.duration, std::nullopt);
    EXPECT_EQ(on.cameras[0].lens.aperture_radius, 1);
    EXPECT_EQ(on.materials[0].reflection_spread_degrees, degrees(0.1));
    EXPECT_EQ(on.materials[0].refraction_spread_degrees, degrees(0.2));
    EXPECT_EQ(std::get<RectLight>(on.lights[0].shape), (RectLight{{0, 5, 0}, {2, 0, 0}, {0, 0, 4}, false}));
    EXPECT_EQ(std::get<SphereLight>(on.lights[1].shape),
              (SphereLight{{1, 2, 3}, 2, SphereLight::Distribution::radial}));

    const SceneRead off = read(
        "settings S { dof_c 1 blur_samples 0 dof_samples 0 soft_shadow_samples 0 diffuse_reflection_samples 0 "
        "diffuse_refraction_samples 0 }" +
        body);
    EXPECT_EQ(off.scene.cameras[0].shutter.duration, 0);
    EXPECT_EQ(off.scene.cameras[0].lens.aperture_radius, 0);
    EXPECT_EQ(off.scene.materials[0].reflection_spread_degrees, 0);
    EXPECT_EQ(off.scene.materials[0].refraction_spread_degrees, 0);
    EXPECT_EQ(std::get<PointLight>(off.scene.lights[0].shape).position, (Vec3d{1, 5, 2}));
    EXPECT_EQ(std::get<PointLight>(off.scene.lights[1].shape).position, (Vec3d{1, 2, 3}));
    for (const char* effect :
         {"no motion blur", "pinholes", "hard shadows", "reflections are sharp", "refractions are sharp"})
        EXPECT_TRUE(says(off, effect)) << effect;
}

TEST(LegacyCamera, EveryAttribute) {
    const SceneDesc s = scene(
        "camera C { video_start 1 video_end 3 time_start 8 time_end 4 DOF_start 2 DOF_end 5 FOV_start 1 FOV_end 2"
        " add_position { 1 2 3 } add_target { 4 5 6 } add_position { 7 8 9 } sky_start { 1 0 0 } sky_end { 0 0 1 } }");
    const Camera& c = s.cameras.at(0);
    EXPECT_EQ(c.name, "C");
    EXPECT_EQ(c.video_start, 1);
    EXPECT_EQ(c.video_end, 3);
    EXPECT_EQ(c.time_start, 8);
    EXPECT_EQ(c.time_end, 4);
    EXPECT_EQ(c.lens.focus_start, 2);
    EXPECT_EQ(c.lens.focus_end, 5);
    EXPECT_EQ(c.fov_degrees_start, degrees(2 * std::atan(0.5)));
    EXPECT_EQ(c.fov_degrees_end, degrees(2 * std::atan(1.0)));
    EXPECT_EQ(c.zoom, Camera::Zoom::image_width);
    EXPECT_TRUE(c.video_end_inclusive);
    EXPECT_EQ(c.positions, (std::vector<Vec3d>{{1, 2, 3}, {7, 8, 9}}));
    EXPECT_EQ(c.targets, (std::vector<Vec3d>{{4, 5, 6}}));
    EXPECT_EQ(c.up_start, (Vec3d{1, 0, 0}));
    EXPECT_EQ(c.up_end, (Vec3d{0, 0, 1}));
}

// FOV goes linearly: the width of the image at distance 1, or its distance.
TEST(LegacyCamera, TheNumberZoomsNotTheAngle) {
    const auto zoom = [](const std::string& attributes, LegacyOptions::Fov fov) {
        LegacyOptions options;
        options.fov = fov;
        return read("camera C { video_end 8 " + attributes + " }", options).scene.cameras.at(0).zoom;
    };
    using Fov = LegacyOptions::Fov;
    EXPECT_EQ(zoom("FOV_start 0.7 FOV_end 1.6", Fov::half_width), Camera::Zoom::image_width);
    EXPECT_EQ(zoom("FOV_start 0.7 FOV_end 1.6", Fov::distance), Camera::Zoom::focal_length);
    EXPECT_EQ(zoom("FOV_end 1.6", Fov::half_width), Camera::Zoom::image_width);  // from an angle of 45 degrees
    for (const Fov fov : {Fov::half_width, Fov::distance})                       // no zoom at all
        for (const char* attributes : {"", "FOV_start 0.7", "FOV_start 0.7 FOV_end 0.7", "FOV_start 0.7 FOV_end -1"})
            EXPECT_EQ(zoom(attributes, fov), Camera::Zoom::angle) << attributes;
}

TEST(LegacyCamera, MinusOneAndAbsenceAreImplicit) {
    const std::string implicit =
        "video_start -1 video_end -1 time_start -1 time_end -1 DOF_start -1 DOF_end -1 FOV_start -1 FOV_end -1.0";
    for (const std::string& attributes : {implicit, std::string()}) {
        const Camera c = scene("camera C { " + attributes + " }").cameras.at(0);
        Camera expected;
        expected.name = "C";
        expected.lens.distribution = Lens::Distribution::radial;
        expected.lens.focus_surface = Lens::FocusSurface::sphere;
        expected.shutter.duration = 0;  // blur_samples is 0 by default
        EXPECT_EQ(c, expected) << attributes;
    }
}

TEST(LegacyCamera, ImplicitTimesFollowTheNeighbours) {
    const SceneDesc s =
        scene("camera A { time_start 2 time_end 5 } camera B { } camera C { video_start 10 time_end 14 } camera D { }");
    EXPECT_EQ(s.cameras[0].video_start, 0);
    EXPECT_EQ(s.cameras[0].video_end, 3);  // as long as the scene time it shows
    EXPECT_EQ(s.cameras[1].video_start, 3);
    EXPECT_EQ(s.cameras[1].video_end, 10);  // until the next one
    EXPECT_EQ(s.cameras[2].video_end, 14);
    EXPECT_EQ(s.cameras[3].video_start, 14);
    EXPECT_EQ(s.cameras[3].video_end, std::nullopt);
    for (const Camera& c : s.cameras) EXPECT_EQ(c.video_end_inclusive, c.video_end.has_value());
}

TEST(LegacyMaterial, EveryAttribute) {
    const SceneDesc s = scene(
        "phong_info P { ambient { 0.1 0.2 0.3 } diffuse { 0.4 0.5 0.6 } specular { 0.7 0.8 0.9 } shininess 33 "
        "reflectance 0.25 diffuse_reflection 0.5 refraction 0.75 diffuse_refraction 0.125 refraction_index 1.6 }"
        "texture T { file a/b.tga } material_texture M { texture T phong_info P scale_U 3 scale_V 2 }" +
        camera);
    Material m;
    m.name = "M";
    m.ambient = {0.1f, 0.2f, 0.3f};
    m.diffuse = {0.4f, 0.5f, 0.6f};
    m.specular = {0.7f, 0.8f, 0.9f};
    m.shininess = 33;
    m.reflectance = 0.25;
    m.reflection_spread_degrees = degrees(0.5);
    m.refraction = 0.75;
    m.refraction_spread_degrees = degrees(0.125);
    m.refraction_index = 1.6;
    m.texture = "T";
    m.scale_u = 3;
    m.scale_v = 2;
    EXPECT_EQ(s.materials.at(0), m);
}

TEST(LegacyMaterial, DefaultsAreThoseOfDrt) {
    const SceneDesc s = scene("phong_info P { } material_phong M { phong_info P } material_phong N { }" + camera);
    for (Material m : s.materials) {
        m.name.clear();
        EXPECT_EQ(m, Material{});
    }
}

TEST(LegacyMaterial, SharedNamesBecomeUnique) {
    const SceneRead r = read(
        "material_phong M { } material_texture M { } sphere a { material_texture M } sphere b { material_phong M } "
        "sphere c { material M } material_texture M_material_texture { }" +
        camera);
    EXPECT_EQ(r.scene.materials[0].name, "M");
    EXPECT_EQ(r.scene.materials[1].name, "M_material_texture_2");
    EXPECT_EQ(r.scene.materials[2].name, "M_material_texture");
    EXPECT_EQ(r.scene.bodies[0].material, "M_material_texture_2");
    EXPECT_EQ(r.scene.bodies[1].material, "M");
    EXPECT_EQ(r.scene.bodies[2].material, "M_material_texture_2");  // the later definition
    EXPECT_TRUE(says(r, "both a material_phong and a material_texture have this name"));
}

TEST(LegacyTexture, FileOrFilenameAndBackslashes) {
    const SceneDesc s =
        scene("texture A { file x.tga } texture B { filename sub\\y.tga } texture C { file /abs/z.tga }" + camera);
    EXPECT_EQ(s.textures[0].file, "x.tga");
    EXPECT_EQ(s.textures[1].file, "sub/y.tga");
    EXPECT_EQ(s.textures[2].file, "/abs/z.tga");
}

TEST(LegacyBody, EveryShape) {
    const SceneDesc s = scene(
        "plane p { normal { 0 0 2 } position { 1 2 3 } } "
        "sphere s { position { 4 5 6 } radius 7 v_e { 1 0 0 } v_n { 0 1 0 } } "
        "triangle t { vertex0 { 1 0 0 } vertex1 { 0 1 0 } vertex2 { 0 0 1 } } "
        "rectangle r { vertex0 { 0 0 1 } vertex1 { 2 0 1 } vertex2 { 1 3 1 } } "
        "rectangle q { vertex0 { 0 0 1 } position1 { 2 0 1 } vertex2 { 1 3 1 } }" +
        camera);
    EXPECT_EQ(s.bodies[0].shape, Shape(Plane{{1, 2, 3}, {0, 0, 2}}));
    EXPECT_EQ(s.bodies[1].shape, Shape(Sphere{{4, 5, 6}, 7, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(s.bodies[2].shape, Shape(Triangle{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_EQ(s.bodies[3].shape, Shape(Rectangle{{0, 0, 1}, {2, 0, 1}, {1, 3, 1}}));
    EXPECT_EQ(s.bodies[4].shape, s.bodies[3].shape);
    EXPECT_EQ(s.bodies[0].material, "default");
    EXPECT_FALSE(s.bodies[1].physics);
}

TEST(LegacyBody, SharedNamesBecomeUnique) {
    const SceneDesc s = scene("plane a { } sphere a { } box a { } sphere a_box { }" + camera);
    EXPECT_EQ(s.bodies[0].name, "a");
    EXPECT_EQ(s.bodies[1].name, "a_sphere");
    EXPECT_EQ(s.bodies[2].name, "a_box_2");
    EXPECT_EQ(s.bodies[3].name, "a_box");
}

TEST(LegacyBody, Physics) {
    const SceneRead r = read(
        "sphere a { use_physics 1 add_force_event { force { 1 2 4 } time 0.5 } add_force_event { time 1 force { 8 0 0 "
        "} } }"
        "sphere b { use_physics 0 add_force_event { force { 1 0 0 } time 0 } } box c { use_physics 1 } box d { }" +
        camera);
    const PhysicsDesc& a = *r.scene.bodies[0].physics;
    EXPECT_EQ(a.kind, PhysicsDesc::Kind::dynamic);
    ASSERT_EQ(a.impulses.size(), 2u);
    EXPECT_EQ(a.impulses[0], (ImpulseEvent{0.5, Vec3d{1, 2, 4} * 0.05, {}}));
    EXPECT_EQ(a.impulses[1], (ImpulseEvent{1, Vec3d{8, 0, 0} * 0.05, {}}));
    EXPECT_FALSE(r.scene.bodies[1].physics);
    EXPECT_TRUE(says(r, "add_force_event without effect"));
    EXPECT_EQ(a.density, 1);
    PhysicsDesc in_the_way;
    in_the_way.kind = PhysicsDesc::Kind::fixed;
    EXPECT_EQ(r.scene.bodies[2].physics, in_the_way);
    EXPECT_FALSE(r.scene.bodies[3].physics);
}

TEST(LegacyLight, EveryKind) {
    const SceneDesc s = scene(
        "light_point a { position { 1 2 3 } color { 0.5 1 2 } } light_rect a { } light_bulb a { radius 3 }" + camera);
    EXPECT_EQ(s.lights[0].shape, LightShape(PointLight{{1, 2, 3}}));
    EXPECT_EQ(s.lights[0].color, (Color{0.5f, 1, 2}));
    EXPECT_EQ(s.lights[1].shape, LightShape(RectLight{}));
    EXPECT_EQ(s.lights[2].shape, LightShape(SphereLight{{0, 0, 0}, 3, SphereLight::Distribution::radial}));
    EXPECT_EQ(s.lights[1].name, "a_light_rect");
    for (const Light& l : s.lights) {
        EXPECT_EQ(l.falloff, Light::Falloff::none);
        EXPECT_FALSE(l.visible);
    }
}

TEST(LegacyLight, AddedOnlyWhereThereIsNone) {
    LegacyOptions o;
    o.add_lights = true;
    EXPECT_EQ(scene("light_point a { }" + camera, o).lights.size(), 1u);
    const SceneDesc s = scene(camera, o);
    ASSERT_EQ(s.lights.size(), 1u);
    // Eye (0, 0, 5), target the origin: half the distance up (y) and left (-x).
    EXPECT_EQ(std::get<SphereLight>(s.lights[0].shape).center, (Vec3d{-2.5, 2.5, 5}));
    EXPECT_EQ(scene(camera).lights.size(), 0u);
}

// ---- the box -------------------------------------------------------------------------------------------------------

/// The corner at (x, y, z) of the unit cube [-1, 1]^3, mapped by the box.
Vec3d corner(const Box& b, double x, double y, double z) {
    return b.center + rotate(b.orientation, Vec3d{x * b.size.x, y * b.size.y, z * b.size.z} * 0.5);
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
    EXPECT_LT(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' '
                                        << b.z;
}

TEST(LegacyBox, AxisAlignedIsExact) {
    const auto b = box_from_base({0, -5, 0}, {200, -5, 0}, {200, -5, 100}, 5);
    ASSERT_TRUE(b);
    EXPECT_EQ(*b, (Box{{100, -2.5, 50}, {200, 5, 100}, {}}));
    EXPECT_EQ(box_from_base({0, -5, 0}, {200, -5, 0}, {200, -5, 100}, -5)->center, (Vec3d{100, -7.5, 50}));
}

TEST(LegacyBox, AnyOrientationHasItsVerticesAndHeight) {
    // Deterministic spread of directions and skew third vertices.
    for (int i = 0; i < 200; ++i) {
        const auto at = [i](double f) { return 3 * std::sin(f * (i + 1)); };
        const Vec3d v0{at(1.1), at(2.3), at(0.7)}, v1{at(3.1), at(1.9), at(4.7)}, v2{at(5.3), at(0.3), at(2.9)};
        const double height = 0.5 + i % 3;
        const auto b = box_from_base(v0, v1, v2, height);
        ASSERT_TRUE(b);
        const Vec3d x = normalize(v1 - v0);
        const Vec3d other = (v2 - v0) - x * dot(v2 - v0, x);
        const Vec3d up = normalize(cross(v2 - v0, v1 - v0)) * height;
        expect_near(corner(*b, -1, -1, -1), v0, 1e-12);
        expect_near(corner(*b, 1, -1, -1), v1, 1e-12);
        expect_near(corner(*b, -1, -1, 1), v0 + other, 1e-12);
        expect_near(corner(*b, -1, 1, -1), v0 + up, 1e-12);
    }
}

TEST(LegacyBox, EveryQuarterTurn) {  // all branches of the rotation's conversion
    const Vec3d axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    int count = 0;
    for (const Vec3d& x : axes)
        for (const Vec3d& z : axes) {
            if (dot(x, z) != 0) {
                EXPECT_FALSE(box_from_base({}, x, z, 1));  // all on one line
                continue;
            }
            const auto b = box_from_base({}, x, z, 1);
            ASSERT_TRUE(b);
            expect_near(rotate(b->orientation, Vec3d{1, 0, 0}), x, 1e-15);
            expect_near(rotate(b->orientation, Vec3d{0, 1, 0}), cross(z, x), 1e-15);
            expect_near(rotate(b->orientation, Vec3d{0, 0, 1}), z, 1e-15);
            ++count;
        }
    EXPECT_EQ(count, 24);
}

TEST(LegacyBox, DegenerateBasesAreRefused) {
    EXPECT_FALSE(box_from_base({1, 1, 1}, {1, 1, 1}, {2, 0, 0}, 1));
    EXPECT_FALSE(box_from_base({0, 0, 0}, {1, 2, 3}, {2, 4, 6}, 1));
    EXPECT_FALSE(box_from_base({0, 0, 0}, {1e200, 0, 0}, {0, 1e200, 0}, 1));
}

}  // namespace
}  // namespace drt
