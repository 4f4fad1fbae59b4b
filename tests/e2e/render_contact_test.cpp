// Pictures of bodies that touch, overlap or surround the eye, whose every pixel is known.

#include <algorithm>
#include <cmath>

#include "render_programs.h"

namespace drt {
namespace {

struct Case {
    std::string name, scene;
    float expected;
};

const std::string materials = R"(
materials:
  - {name: floor, ambient: 0.6, diffuse: 0}
  - {name: strip, ambient: 1, diffuse: 0}
  - {name: mirror, ambient: 0, diffuse: 0, reflectance: 1}
  - {name: water, ambient: 0, diffuse: 0, refraction: 1, refraction_index: 1.33}
  - {name: glass, ambient: 0, diffuse: 0, refraction: 1, refraction_index: 1.5}
)";

/// Seen from above through glass whose lower face is at y = 0: nothing but what is below it may be seen.
std::string from_above(const std::string& bodies, int max_depth) {
    return "drt: 1\nrender: {width: 16, height: 16, spp: 16, max_depth: " + std::to_string(max_depth) +
           ", filter: {kind: box, radius: 0.5}}\nambient_light: 1\nbackground: 0.1" + materials + "bodies:\n" + bodies +
           "cameras: [{position: [3, 4, 1], target: [0, 0, 0], fov_degrees: 5}]\n";
}

/// One narrow beam from (0, y, 0), `degrees` from the vertical: white where it meets the strip at y = -20 about x.
std::string beam(const std::string& bodies, double x, double y = 5, double degrees = 40) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    char text[600];
    std::snprintf(text, sizeof text,
                  "  - {name: strip, type: rectangle, vertex0: [%.17g, -20, -9], vertex1: [%.17g, -20, -9], "
                  "vertex2: [%.17g, -20, 9], material: strip}\n"
                  "cameras: [{position: [0, %.17g, 0], target: [%.17g, %.17g, 0], up: [0, 0, 1], "
                  "fov_degrees: 0.0001}]\n",
                  x - 0.3, x + 0.3, x + 0.3, y, std::sin(angle), y - std::cos(angle));
    return "drt: 1\nrender: {width: 4, height: 4, spp: 4, max_depth: 64, filter: {kind: point}}\nambient_light: 1" +
           materials + "bodies:\n" + bodies + text;
}

/// Where the beam lands, through layers {thickness, index} in air.
double landing(std::initializer_list<std::pair<double, double>> layers, double from_y = 5, double sine = 0,
               double start_index = 1) {
    const double invariant = (sine != 0 ? sine : std::sin(40 * 3.14159265358979323846 / 180)) * start_index;
    double x = 0, depth = from_y + 20;
    for (const auto& [thickness, index] : layers) {
        x += thickness * std::tan(std::asin(invariant / index));
        depth -= thickness;
    }
    return x + depth * std::tan(std::asin(invariant));
}

std::string slab(const std::string& material, double bottom, double top, const std::string& more = "") {
    char text[200];
    std::snprintf(text, sizeof text,
                  "  - {type: box, center: [0, %.17g, 0], size: [200, %.17g, 200], material: %s%s}\n",
                  (bottom + top) / 2, top - bottom, material.c_str(), more.c_str());
    return text;
}

std::vector<Case> cases() {
    const std::string block = "  - {type: box, center: [0, 0.5, 0], size: [9, 1, 9], material: glass}\n";
    const std::string drum = "  - {type: cylinder, from: [0, 0, 0], to: [0, 1, 0], radius: 6, material: glass}\n";
    const auto floors = [](const std::string& m) {
        return std::vector<std::pair<std::string, std::string>>{
            {"plane", "  - {type: plane, material: " + m + "}\n"},
            {"upside_down_plane", "  - {type: plane, normal: [0, -1, 0], material: " + m + "}\n"},
            {"rectangle",
             "  - {type: rectangle, vertex0: [-9, 0, -9], vertex1: [9, 0, -9], vertex2: [9, 0, 9], material: " + m +
                 "}\n"},
            {"disc", "  - {type: disc, center: [0, 0, 0], normal: [0, 1, 0], radius: 9, material: " + m + "}\n"},
            {"box", "  - {type: box, center: [0, -1, 0], size: [20, 2, 20], material: " + m + "}\n"},
            {"cylinder", "  - {type: cylinder, from: [0, -3, 0], to: [0, 0, 0], radius: 9, material: " + m + "}\n"},
            {"room", "  - {type: box, center: [0, 5, 0], size: [20, 10, 20], material: " + m + "}\n"}};
    };
    std::vector<Case> out;
    for (const auto& [kind, glass] : {std::pair{"block", block}, std::pair{"drum", drum}}) {
        for (const auto& [name, floor] : floors("floor")) {
            out.push_back({std::string(kind) + "_on_" + name, from_above(floor + glass, 16), 0.6f});
            out.push_back({std::string(kind) + "_before_" + name, from_above(glass + floor, 16), 0.6f});
        }
        for (const auto& [name, floor] : floors("mirror")) {
            if (name == "room") continue;  // its walls mirror, too
            out.push_back({std::string(kind) + "_on_mirror_" + name, from_above(floor + glass, 3), 0.1f});
            out.push_back({std::string(kind) + "_before_mirror_" + name, from_above(glass + floor, 3), 0.1f});
        }
    }
    const auto add = [&](const std::string& name, const std::string& scene) { out.push_back({name, scene, 1}); };
    const double two = landing({{4, 1.33}, {4, 1.5}});
    add("glass_on_glass", beam(slab("water", 0, 4) + slab("glass", -4, 0), two));
    add("glass_on_glass_reversed", beam(slab("glass", -4, 0) + slab("water", 0, 4), two));
    add("a_dense_slab_on_a_thin_one", beam(slab("glass", 0, 4) + slab("water", -4, 0), two));
    add("of_overlapping_slabs_the_smaller_owns",
        beam(slab("water", 0, 4) + slab("glass", -4, 2), landing({{4, 1.33}, {4, 1.5}})));
    add("the_smaller_owns_in_any_order",
        beam(slab("glass", -4, 2) + slab("water", 0, 4), landing({{4, 1.33}, {4, 1.5}})));
    add("priority_owns",
        beam(slab("water", 0, 4) + slab("glass", -4, 2, ", priority: 1"), landing({{2, 1.33}, {6, 1.5}})));
    add("of_equals_the_later_owns", beam(slab("water", -2, 4) + slab("glass", -4, 2), landing({{2, 1.33}, {6, 1.5}})));
    add("a_plane_owns_least", beam("  - {type: plane, position: [0, 4, 0], material: water}\n" + slab("glass", -4, 0),
                                   // the water has no lower end: the strip is within it
                                   4 * std::tan(std::asin(std::sin(40 * 3.14159265358979323846 / 180) / 1.5)) +
                                       std::tan(40 * 3.14159265358979323846 / 180) +
                                       20 * std::tan(std::asin(std::sin(40 * 3.14159265358979323846 / 180) / 1.33))));
    add("the_eye_in_nested_slabs",
        beam(slab("water", -4, 4) + slab("glass", -2, 2), landing({{2, 1.5}, {2, 1.33}}, 0, 0.5, 1.5), 0, 30));
    add("the_eye_in_an_overlap", beam(slab("water", -4, 4) + slab("glass", -2, 6),
                                      // of equal volumes the later one owns
                                      landing({{2, 1.5}, {2, 1.33}}, 0, 0.5, 1.5), 0, 30));
    add("the_eye_in_what_does_not_own",
        beam(slab("water", -4, 4, ", priority: 2") + slab("glass", -2, 2), landing({{4, 1.33}}, 0, 0.5, 1.33), 0, 30));
    return out;
}

class Contact : public testing::TestWithParam<Case> {};

TEST_P(Contact, ShowsWhatIsThere) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", GetParam().scene);
    for (const std::string precision : {"single", "double"}) {
        const Image picture = render_exr(folder, precision, {scene, "--precision", precision});
        float worst = 0;
        for (size_t i = 0; i < picture.data.size(); ++i)
            if (i % 4 != 3) worst = std::max(worst, std::abs(picture.data[i] - GetParam().expected));
        EXPECT_LT(worst, 1e-6f) << precision;
    }
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

INSTANTIATE_TEST_SUITE_P(Scenes, Contact, testing::ValuesIn(cases()),
                         [](const testing::TestParamInfo<Case>& c) { return c.param.name; });

// A die that falls on a table and comes to rest is in contact with it.
TEST(ContactOfPhysics, ADieAtRestShowsTheTable) {
    const TempFolder folder;
    const std::string scene = folder.write("scene.yaml", R"(drt: 1
render: {width: 32, height: 24, spp: 16, max_depth: 16}
ambient_light: 1
background: 0.1
materials:
  - {name: floor, ambient: 0.6, diffuse: 0}
  - {name: glass, ambient: 0, diffuse: 0, refraction: 1, refraction_index: 1.5}
bodies:
  - {name: floor, type: plane, material: floor, physics: {kind: static}}
  - {name: die, type: box, center: [0, 1.5, 0], size: [1, 1, 1], material: glass, physics: {}}
cameras: [{position: [0.3, 3, 0.2], target: [0, 0, 0], up: [0, 0, -1], fov_degrees: 30, video_end: 4, shutter: {duration: 0}}]
)");
    const Image picture = render_exr(folder, "die", {scene, "-f", "50", "--no-bake-cache"});
    for (size_t i = 0; i < picture.data.size(); ++i) ASSERT_NEAR(picture.data[i], i % 4 == 3 ? 1 : 0.6, 1e-5) << i;
}

// Walls that only touch, with bright lights outside.
TEST(ContactOfWalls, KeepARoomDark) {
    const std::string head =
        "drt: 1\nrender: {width: 80, height: 60, spp: 64, max_depth: 8}\n"
        "materials: [{name: m, diffuse: 0.9, reflectance: 0.1}]\nbodies:\n";
    const std::string tail =
        "lights: [{type: sphere, center: [5,5,5], radius: 1, color: 1e5}, "
        "{type: point, position: [-3, 8, 2], color: 1e5}]\n"
        "cameras: [{position: [0.7,0.6,0.8], target: [-1,-1,-1], fov_degrees: 100}]\n";
    const auto rectangle = [](const std::string& a, const std::string& b, const std::string& c) {
        return "  - {type: rectangle, vertex0: " + a + ", vertex1: " + b + ", vertex2: " + c + ", material: m}\n";
    };
    const std::string rectangles =
        rectangle("[-1,-1,-1]", "[1,-1,-1]", "[-1,-1,1]") + rectangle("[-1,1,-1]", "[1,1,-1]", "[-1,1,1]") +
        rectangle("[-1,-1,-1]", "[-1,1,-1]", "[-1,-1,1]") + rectangle("[1,-1,-1]", "[1,1,-1]", "[1,-1,1]") +
        rectangle("[-1,-1,-1]", "[1,-1,-1]", "[-1,1,-1]") + rectangle("[-1,-1,1]", "[1,-1,1]", "[-1,1,1]");
    std::string planes;
    for (const std::string n : {"[1,0,0]", "[-1,0,0]", "[0,1,0]", "[0,-1,0]", "[0,0,1]", "[0,0,-1]"})
        planes += "  - {type: plane, position: " + n + ", normal: " + n + ", material: m}\n";
    const TempFolder folder;
    for (const std::string& walls : {rectangles, planes}) {
        const Image picture =
            render_exr(folder, "room", {folder.write("room.yaml", head + walls + tail), "--precision", "single"});
        for (size_t i = 0; i < picture.data.size(); ++i) ASSERT_TRUE(i % 4 == 3 || picture.data[i] == 0) << i;
    }
}

}  // namespace
}  // namespace drt
