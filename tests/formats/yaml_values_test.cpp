// What values may look like, hostile files of any size, and files broken at random.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <ctime>
#include <locale>
#include <random>

#include "drt/base/constants.h"
#include "drt/formats/formats.h"
#include "drt/scene/value_text.h"
#include "formats/random_scene.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

SceneDesc read(const std::string& text) {
    const TemporaryFiles files;
    return read_yaml_scene(files.write("scene.yaml", text)).scene;
}

TEST(YamlValues, ColoursInEverySpelling) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras: [{}]\n"
        "ambient_light: 0.25\n"
        "background: [0.5, 2, 1e-3]\n"
        "materials:\n"
        "  - {name: a, diffuse: \"#ff8000\", specular: '#FFFFFF', ambient: \"#000000\"}\n");
    EXPECT_EQ(scene.ambient_light, Color{0.25f});
    EXPECT_EQ(scene.background, (Color{0.5f, 2, 0.001f}));
    const Material& m = scene.materials[0];
    EXPECT_EQ(m.diffuse.r, 1);
    EXPECT_NEAR(m.diffuse.g, 0.215860500, 1e-7);  // ((128/255 + 0.055) / 1.055)^2.4
    EXPECT_EQ(m.diffuse.b, 0);
    EXPECT_EQ(m.specular, Color{1.0f});
    EXPECT_EQ(m.ambient, Color{0.0f});
}

TEST(YamlValues, NumbersInEverySpelling) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras: [{}]\n"
        "render: {width: 1e3, height: 240.0, spp: +7, fps: .5, seed: 4294967295}\n"
        "gravity: [0, -0.0, +5.]\n");
    EXPECT_EQ(scene.render.width, 1000);
    EXPECT_EQ(scene.render.height, 240);
    EXPECT_EQ(scene.render.spp, 7);
    EXPECT_EQ(scene.render.fps, 0.5);
    EXPECT_EQ(scene.render.seed, 4294967295u);
    EXPECT_EQ(scene.gravity, (Vec3d{0, 0, 5}));
}

TEST(YamlValues, OrientationsAreQuaternionsOrTurns) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras: [{}]\n"
        "materials: [{name: m}]\n"
        "bodies:\n"
        "  - {type: box, material: m, orientation: [1, 2, 3, 4]}\n"
        "  - {type: box, material: m, orientation: {axis: [0, 0, 5], degrees: 90}}\n");
    const auto orientation = [&](std::size_t i) { return std::get<Box>(scene.bodies[i].shape).orientation; };
    EXPECT_EQ(orientation(0), (Quatd{1, 2, 3, 4}));
    const Vec3d turned = rotate(orientation(1), Vec3d{1, 0, 0});
    EXPECT_NEAR(turned.x, 0, 1e-15);
    EXPECT_NEAR(turned.y, 1, 1e-15);
}

TEST(YamlValues, StartAndEndOrOneForBoth) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras:\n"
        "  - fov_degrees: 30\n"
        "    up: {start: [1, 1, 0], end: [0, 1, 0]}\n"
        "    lens: {focus_distance: {end: 3}}\n"
        "    target: [1, 0, 0]\n"
        "    positions: [[0, 0, 9], [0, 1, 9]]\n"
        "    video_end: 1\n"
        "    video_end_inclusive: true\n"
        "  - {fov_degrees: {start: 20, end: 40}, zoom: focal_length, video_start: 2, video_end: 3}\n");
    const Camera& c = scene.cameras[0];
    EXPECT_EQ(c.fov_degrees_start, 30);
    EXPECT_EQ(c.fov_degrees_end, std::nullopt);
    EXPECT_EQ(c.up_start, (Vec3d{1, 1, 0}));
    EXPECT_EQ(c.up_end, (Vec3d{0, 1, 0}));
    EXPECT_EQ(c.lens.focus_start, std::nullopt);
    EXPECT_EQ(c.lens.focus_end, 3);
    EXPECT_EQ(c.targets, (std::vector<Vec3d>{{1, 0, 0}}));
    EXPECT_EQ(c.positions, (std::vector<Vec3d>{{0, 0, 9}, {0, 1, 9}}));
    EXPECT_TRUE(c.video_end_inclusive);
    EXPECT_EQ(c.zoom, Camera::Zoom::angle);
    EXPECT_EQ(scene.cameras[1].zoom, Camera::Zoom::focal_length);
    EXPECT_FALSE(scene.cameras[1].video_end_inclusive);
}

TEST(YamlValues, KeysRepeatThePositionOfTheKeyBefore) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras:\n"
        "  - motion:\n"
        "      interpolation: cubic\n"
        "      keys:\n"
        "        - {time: 0, position: [1, 2, 3]}\n"
        "        - {time: 1, turn: {axis: [0, 0, 1], degrees: 720}}\n"
        "        - {time: 2, position: [4, 5, 6], orientation: [0, 1, 0, 0]}\n"
        "        - time: 3\n");
    const Motion& m = *scene.cameras[0].motion;
    EXPECT_EQ(m.interpolation, Motion::Interpolation::cubic);
    ASSERT_EQ(m.keys.size(), 4u);
    EXPECT_EQ(m.keys[1].position, (Vec3d{1, 2, 3}));
    EXPECT_EQ(m.keys[1].turn, (Turn{{0, 0, 1}, 720}));
    EXPECT_EQ(m.keys[2].orientation, (Quatd{0, 1, 0, 0}));
    EXPECT_EQ(m.keys[3].position, (Vec3d{4, 5, 6}));
    EXPECT_EQ(m.keys[3].orientation, std::nullopt);
}

TEST(YamlValues, AliasesStandForTheirAnchors) {
    const SceneDesc scene = read(
        "drt: 1\n"
        "cameras: [{}]\n"
        "materials:\n"
        "  - {name: a, diffuse: &red [1, 0, 0]}\n"
        "  - {name: b, diffuse: *red, specular: *red}\n");
    EXPECT_EQ(scene.materials[1].specular, (Color{1, 0, 0}));
}

TEST(YamlValues, EditorsMayAddMarksAndLineEnds) {
    const TemporaryFiles files;
    const std::string path = files.write("scene.yaml",
                                         "\xef\xbb\xbf"
                                         "drt: 1\r\ncameras: [{}]\r\nambient_light: 1\r\n");
    EXPECT_EQ(read_yaml_scene(path).scene.sources.find("ambient_light"), (Location{path, 3, 16}));
}

TEST(YamlValues, ColumnsCountCharacters) {
    const TemporaryFiles files;
    const std::string path = files.write(
        "scene.yaml", "drt: 1\ncameras: [{name: \"\xc5\x99\xe2\x82\xac\xf0\x9f\x98\x80\", video_start: 3}]\n");
    EXPECT_EQ(read_yaml_scene(path).scene.sources.find("cameras[0].video_start"), (Location{path, 2, 38}));
}

TEST(YamlValues, TabsBetweenValuesAreFine) {
    EXPECT_EQ(read("drt: 1\ncameras:\t[{}]\t# a tab\n\t\n\t# another\nrender: {spp:\t3}\n").render.spp, 3);
}

struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(YamlValues, TheLocaleDoesNotMatter) {
    SceneDesc scene;
    scene.cameras.resize(1);
    scene.cameras[0].positions = {{0.5, 1234567.25, 1e-3}};
    const std::string before = write_yaml_scene(scene, "");
    const std::locale old = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
    const std::string text = write_yaml_scene(scene, "");
    const SceneDesc back = read(text);
    std::locale::global(old);
    EXPECT_EQ(text, before);
    EXPECT_EQ(back, scene);
}

// ---- hostile files -------------------------------------------------------------------------------------------------

// The first message about a file that starts as a scene does.
std::string first_error_of(const std::string& text) {
    const TemporaryFiles files;
    const std::string path = files.write("bad.yaml", text);
    const std::clock_t start = std::clock();
    std::string message = "was read";
    try {
        read_yaml_scene(path);
    } catch (const Error& e) {
        message = files.without_folder(to_string(e.diagnostics().front()));
    }
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    constexpr double limit = 10;
#else
    constexpr double limit = 1;
#endif
    EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, limit);
    return message;
}

std::string repeat(const std::string& s, int n) {
    std::string out;
    for (int i = 0; i < n; ++i) out += s;
    return out;
}

const std::string too_deep = "error: nesting too deep \"";

TEST(HostileYaml, DeepNesting) {
    for (const int n : {100, 1000, 100000, 1000000}) {
        EXPECT_EQ(first_error_of("a: " + repeat("[", n)).find("bad.yaml:1:68: " + too_deep), 0u) << n;
        EXPECT_EQ(first_error_of("a: " + repeat("{", n)).find("bad.yaml:1:68: " + too_deep), 0u) << n;
        EXPECT_NE(first_error_of(repeat("- ", n)).find(too_deep), std::string::npos) << n;
        EXPECT_NE(first_error_of(repeat("? ", n)).find(too_deep), std::string::npos) << n;
    }
    EXPECT_NE(first_error_of(repeat("[a, ", 100000)).find(too_deep), std::string::npos);
    std::string staircase;
    for (int i = 0; i < 2000; ++i) staircase += repeat(" ", i) + "a:\n";
    EXPECT_EQ(first_error_of(staircase).find("bad.yaml:65:65: " + too_deep), 0u);
    // what is not too deep gets through to the reader
    EXPECT_EQ(first_error_of("drt: 1\ncameras: [{}]\nrender: " + repeat("[", 60) + repeat("]", 60)),
              "bad.yaml:3:9: error: render is a list; expected the keys of render");
}

TEST(HostileYaml, BillionLaughs) {
    std::string text = "drt: 1\na: &a [x, x, x, x, x, x, x, x, x, x]\n";
    for (char c = 'b'; c <= 'j'; ++c) {
        const std::string below = std::string("*") + char(c - 1);
        text += std::string(1, c) + ": &" + c + " [" + repeat(below + ", ", 9) + below + "]\n";
    }
    EXPECT_EQ(
        first_error_of(text),
        "bad.yaml:8:44: error: too many values \"*f\"; expected at most 1e7 values, those of aliases counted each "
        "time");
}

TEST(HostileYaml, AliasesThatNestDeeply) {
    std::string text = "a0: &a0 [1]\n", below = "a0";
    for (int i = 1; i < 200; ++i) {
        const std::string name = std::string("a").append(std::to_string(i));
        text.append(name).append(": &").append(name).append(" [*").append(below).append("]\n");
        below = name;
    }
    EXPECT_NE(first_error_of(text).find(too_deep), std::string::npos);
}

TEST(HostileYaml, FilesAreLimitedTo64Megabytes) {
    EXPECT_EQ(first_error_of(std::string((64 << 20) + 1, '#')),
              "bad.yaml: error: the file is too large; expected at most 64 MB; put very many balls into a "
              "sphere_set");
}

TEST(HostileYaml, ManyFaultsAreCounted) {
    std::string text = "drt: 1\ncameras: [{}]\nmaterials:\n";
    for (int i = 0; i < 5000; ++i) text += "  - {name: m" + std::to_string(i) + ", shinyness: 3}\n";
    const TemporaryFiles files;
    try {
        read_yaml_scene(files.write("bad.yaml", text));
        FAIL();
    } catch (const Error& e) {
        ASSERT_EQ(e.diagnostics().size(), 101u);
        EXPECT_EQ(to_string(e.diagnostics().back()), "note: 4900 more errors");
    }
}

TEST(HostileYaml, LongTextsAreCutInMessages) {
    const std::string message = first_error_of("drt: 1\ncameras: [{}]\nrender: {spp: " + repeat("x", 100000) + "}\n");
    EXPECT_EQ(message, "bad.yaml:3:15: error: spp is not a number \"" + repeat("x", 60) +
                           "...\"; expected an integer >= 1 and <= 16777216");
}

std::string broken(std::string text, std::mt19937& random) {
    constexpr std::string_view alphabet = "[]{}:,-#&*!|>'\"%@` \n\t?~0123456789.eE+x_<\\\xff\xc3";
    const auto below = [&](std::size_t n) { return std::size_t(random()) % n; };
    for (std::size_t n = 1 + below(4); n > 0 && !text.empty(); --n) {
        const std::size_t at = below(text.size()), length = below(std::min<std::size_t>(40, text.size() - at) + 1);
        switch (below(5)) {
            case 0:
                text[at] = alphabet[below(alphabet.size())];
                break;
            case 1:
                text.insert(at, 1, alphabet[below(alphabet.size())]);
                break;
            case 2:
                text.erase(at, length);
                break;
            case 3:
                text.insert(below(text.size()), text.substr(at, length));
                break;
            case 4:
                text.resize(at);
                break;
        }
    }
    return text;
}

// Whatever a file holds, reading it ends, with a scene or with an Error.
TEST(HostileYaml, FilesBrokenAtRandomOnlyThrowErrors) {
    const TemporaryFiles files;
    std::vector<std::string> whole;
    for (std::uint32_t seed = 0; seed < 20; ++seed) whole.push_back(write_yaml_scene(random_scene(seed), ""));
    std::mt19937 random(7);
    int was_read = 0, was_refused = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
        try {
            read_yaml_scene(files.write("broken.yaml", broken(whole[i % whole.size()], random)));
            ++was_read;
        } catch (const Error& e) {
            ASSERT_FALSE(e.diagnostics().empty());
            ++was_refused;
        }
    }
    EXPECT_GT(was_read, 40);
    EXPECT_GT(was_refused, 1000);
}

}  // namespace
}  // namespace drt
