// Converting and reading directly give the same scene, bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "formats/legacy_fixture.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

void expect_same_after_yaml(const std::string& text, const LegacyOptions& options = {}) {
    const TemporaryFiles files;
    const SceneDesc direct = read_legacy_scene(files.write("scene.txt", text), options).scene;
    const std::string yaml = files.write("scene.yaml", write_yaml_scene(direct, files.folder(), "from a test"));
    EXPECT_TRUE(read_yaml_scene(yaml).scene == direct) << text;
}

TEST(LegacyYaml, EveryElementAndAttribute) {
    expect_same_after_yaml(
        "settings S { width 320 height 200 fps 12.5 interpolate_samples 3 blur_samples 4 blur_duration 0.1 "
        "blur_switch_ratio 0.3 dof_samples 5 dof_c 0.35 soft_shadow_samples 6 diffuse_reflection_samples 7 "
        "diffuse_refraction_samples 8 recursion 2 }\n"
        "camera A { video_start 0.1 video_end 3.3 time_start 7.7 time_end -1 DOF_start 20.1 DOF_end 60.3 FOV_start 2.5 "
        "FOV_end 0.7 add_position { 0.1 0.2 5 } add_position { 1 2 3 } add_target { 0 0 0 } sky_start { 0.1 1 0 } "
        "sky_end { 0.3 1 0.2 } }\ncamera B { }\n"
        "phong_info P { ambient { 0.6 0.1 0.7 } diffuse { 0.3 0.33 0.333 } specular { 0.7 0.7 0.7 } shininess 21.7 "
        "reflectance 0.2 diffuse_reflection 0.15 refraction 0.4 diffuse_refraction 0.07 refraction_index 1.31 }\n"
        "texture T { file textures/a.tga } texture U { file ../b.tga } texture V { file /c.tga }\n"
        "material_phong M { phong_info P } material_texture M { phong_info P texture T scale_U 0.3 scale_V 0.7 }\n"
        "plane a { normal { 0.1 1 0.2 } position { 0.3 0.4 0.5 } material_phong M }\n"
        "sphere a { position { 0.1 0.2 0.3 } radius 0.7 v_e { 0.1 1 0 } v_n { 1 0 1 } material_texture M use_physics 1 "
        "add_force_event { force { 0.1 7 -3 } time 0.3 } add_force_event { force { 1e5 0 0 } time 1.1 } }\n"
        "triangle a { vertex0 { 0.1 0 0 } vertex1 { 0 0.3 0 } vertex2 { 0 0 0.7 } }\n"
        "rectangle a { vertex0 { 0.1 0 0 } position1 { 0 0.3 0 } vertex2 { 0 0 0.7 } }\n"
        "box a { vertex0 { 0.1 0 0 } vertex1 { 0 0.3 0.2 } vertex2 { 0.4 0 0.7 } height -0.9 use_physics 1 }\n"
        "light_point a { position { 0.1 0.2 0.3 } color { 0.9 0.8 0.7 } } "
        "light_rect a { position { 0.1 9 0 } x { 0.3 0 0.1 } y { 0 0.1 0.7 } } light_bulb a { radius 0.3 }\n");
}

TEST(LegacyYaml, EffectsThatAreOff) {
    expect_same_after_yaml(
        "settings S { blur_samples 0 dof_samples 0 soft_shadow_samples 0 diffuse_reflection_samples 0 "
        "diffuse_refraction_samples 0 } camera C { } light_rect L { }");
}

TEST(LegacyYaml, OptionsAreWrittenOut) {
    LegacyOptions o;
    o.fov = LegacyOptions::Fov::distance;
    o.gravity = {0.1, -1.62, 0.3};
    o.density = 0.7;
    o.legacy_step = 1.0 / 60;
    o.ambient_light = 0.15f;
    o.add_lights = true;
    expect_same_after_yaml(
        "camera C { FOV_start 2.5 FOV_end 0.7 video_end 3 } sphere s { use_physics 1 add_force_event { force { 1 2 3 } "
        "time 0.1 } }",
        o);
}

TEST(LegacyYaml, BoxesInAnyOrientation) {
    std::mt19937 rng(6);
    std::uniform_real_distribution<double> coordinate(-10, 10);
    std::string text = "camera C { }\n";
    for (int i = 0; i < 300; ++i) {
        const auto vertex = [&] {
            return "{ " + std::to_string(coordinate(rng)) + ' ' + std::to_string(coordinate(rng)) + ' ' +
                   std::to_string(coordinate(rng)) + " }";
        };
        text += "box b" + std::to_string(i) + " { vertex0 " + vertex() + " vertex1 " + vertex() + " vertex2 " +
                vertex() + " }\n";
    }
    expect_same_after_yaml(text);
}

}  // namespace
}  // namespace drt
