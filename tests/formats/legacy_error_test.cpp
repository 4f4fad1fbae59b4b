// Everything that can be wrong in a legacy file: what is said, and where.
#include <gtest/gtest.h>

#include <ctime>
#include <random>

#include "formats/legacy_fixture.h"

namespace drt {
namespace {

using legacy_test::camera;
using legacy_test::errors_of;
using legacy_test::read;

struct Case {
    const char* name;
    std::string text;
    std::string errors;  // exactly these lines
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class LegacyErrors : public testing::TestWithParam<Case> {};

TEST_P(LegacyErrors, AreSaidWithTheirPlace) { EXPECT_EQ(errors_of(GetParam().text), GetParam().errors); }

const Case cases[] = {
    {"unknown_element", "spher a { radius 1 }\n" + camera,
     "scene.txt:1:1: error: unknown element \"spher\"; expected settings, camera, a material, a body or a light; "
     "did you mean \"sphere\"?\n"},
    {"unknown_element_not_near", "torus a { radius 1 }\n" + camera,
     "scene.txt:1:1: error: unknown element \"torus\"; expected settings, camera, a material, a body or a light\n"},
    {"unknown_attribute", "sphere a {\n  radiuss 1\n}\n" + camera,
     "scene.txt:2:3: error: unknown attribute of sphere \"radiuss\"; did you mean \"radius\"?\n"},
    {"unknown_attribute_with_vector", "sphere a { colour { 1 0 0 } radius 2 }\n" + camera,
     "scene.txt:1:12: error: unknown attribute of sphere \"colour\"\n"},
    {"several_at_once", "sphere a { radius x }\nbox b { heigth 1 }\n" + camera,
     "scene.txt:1:19: error: not a number \"x\"; expected a number > 0\n"
     "scene.txt:2:9: error: unknown attribute of box \"heigth\"; did you mean \"height\"?\n"},
    {"syntax_and_reference_errors_together", "sphere a { radius x material M }\n" + camera,
     "scene.txt:1:19: error: not a number \"x\"; expected a number > 0\n"
     "scene.txt:1:30: error: undefined material \"M\"; expected the name of an element defined above\n"},
    {"duplicate_attribute", "sphere a { radius 1\n radius 2 }\n" + camera,
     "scene.txt:2:2: error: the attribute is given twice (first at line 1) \"radius\"; expected each attribute once\n"},
    {"duplicate_by_alias", "rectangle a { vertex1 { 1 0 0 } position1 { 1 0 0 } }\n" + camera,
     "scene.txt:1:33: error: the attribute is given twice (first at line 1) \"position1\"; expected each attribute "
     "once\n"},
    {"duplicate_element", "plane a { }\nplane a { }\n" + camera,
     "scene.txt:2:7: error: a second plane of this name (the first is at line 1) \"a\"; expected names that differ "
     "within a kind\n"},
    {"second_settings", "settings a { }\nsettings b { }\n" + camera,
     "scene.txt:2:1: error: a second settings element (the first is at line 1) \"b\"; expected one for the whole "
     "scene\n"},
    {"no_camera", "settings a { }", "scene.txt: error: the scene has no camera; expected at least one\n"},
    {"empty_file", "", "scene.txt: error: the scene has no camera; expected at least one\n"},
    {"no_name", "sphere { radius 1 }\n" + camera,
     "scene.txt:1:8: error: a sphere without a name \"{\"; expected sphere name { ... }\n"},
    {"no_open_brace", "sphere a radius 1 }\n" + camera,
     "scene.txt:1:10: error: missing \"{\" after sphere a \"radius\"; expected \"{\"\n"},
    {"no_close_brace", "sphere a { radius 1\nplane b { }\n" + camera,
     "scene.txt:2:1: error: missing \"}\" of the sphere that begins at line 1 \"plane\"; expected \"}\"\n"},
    {"no_close_brace_before_a_reference_kind",
     "phong_info P { }\ntexture T { file a }\nmaterial_texture M { phong_info P\ntexture U { file b }\n" + camera,
     "scene.txt:4:1: error: missing \"}\" of the material_texture that begins at line 3 \"texture\"; expected \"}\"\n"},
    {"no_close_brace_at_end", camera + "sphere a { radius 1\n",
     "scene.txt:3:1: error: missing \"}\" of the sphere that begins at line 2; expected \"}\"\n"},
    {"stray_close_brace", "plane a { } }\n" + camera,
     "scene.txt:1:13: error: a brace outside of any element \"}\"; expected an element: kind name { ... }\n"},
    {"stray_open_brace", "plane a { { 1 2 } }\n" + camera,
     "scene.txt:1:11: error: a brace where an attribute should be \"{\"; expected an attribute of plane\n"},
    {"vector_of_two", "sphere a { position { 1 2 } }\n" + camera,
     "scene.txt:1:21: error: \"position\" with 2 numbers; expected { x y z }\n"},
    {"vector_of_four", "sphere a { position { 1 2 3 4 } }\n" + camera,
     "scene.txt:1:21: error: \"position\" with 4 numbers; expected { x y z }\n"},
    {"vector_without_open", "sphere a { position 1 2 3 } \n" + camera,
     "scene.txt:1:21: error: missing \"{\" after \"position\" \"1\"; expected { x y z }\n"},
    {"vector_without_close", "sphere a { position { 1 2 3 radius 2 }\n" + camera,
     "scene.txt:1:29: error: missing \"}\" of \"position\" \"radius\"; expected { x y z }\n"},
    {"vector_with_word", "sphere a { position { 1 up 3 } }\n" + camera,
     "scene.txt:1:25: error: not a number \"up\"; expected a number\n"},
    {"color_too_large", "phong_info a { diffuse { 1e39 0 0 } }\n" + camera,
     "scene.txt:1:26: error: \"diffuse\" too large \"1e39\"; expected a number of at most 1e+15 in size\n"},
    {"number_in_braces", "sphere a { radius { 2 } }\n" + camera,
     "scene.txt:1:19: error: \"radius\" takes one value without braces; expected a number > 0\n"},
    {"number_missing", "sphere a { radius }\n" + camera,
     "scene.txt:1:19: error: \"radius\" has no value \"}\"; expected a number > 0\n"},
    {"number_missing_before_attribute", "sphere a { radius use_physics 0 }\n" + camera,
     "scene.txt:1:19: error: \"radius\" has no value \"use_physics\"; expected a number > 0\n"},
    {"two_numbers", "sphere a { radius 1 2 }\n" + camera,
     "scene.txt:1:21: error: too many numbers after \"radius\" \"2\"; expected a number > 0\n"},
    {"number_out_of_range", "sphere a { radius -1 }\n" + camera,
     "scene.txt:1:19: error: \"radius\" out of range \"-1\"; expected a number > 0\n"},
    {"decimal_comma", "sphere a { radius 1,5 }\n" + camera,
     "scene.txt:1:19: error: a decimal comma; the format has a decimal point \"1,5\"; expected a number > 0\n"},
    {"nan", "sphere a { radius nan }\n" + camera,
     "scene.txt:1:19: error: not a number \"nan\"; expected a number > 0\n"},
    {"inf", "sphere a { radius inf }\n" + camera,
     "scene.txt:1:19: error: not a number \"inf\"; expected a number > 0\n"},
    {"1e400", "sphere a { radius 1e400 }\n" + camera,
     "scene.txt:1:19: error: the number is out of the range of a double \"1e400\"; expected a number > 0\n"},
    {"hexadecimal", "sphere a { radius 0x10 }\n" + camera,
     "scene.txt:1:19: error: not a number \"0x10\"; expected a number > 0\n"},
    {"trailing_letters", "sphere a { radius 1.5abc }\n" + camera,
     "scene.txt:1:19: error: not a number \"1.5abc\"; expected a number > 0\n"},
    {"not_whole", "settings s { width 640.5 }\n" + camera,
     "scene.txt:1:20: error: \"width\" out of range \"640.5\"; expected a whole number from 1 to 65536\n"},
    {"one_limit_of_picture_sizes",
     "settings s { width 65537 height 1000000 recursion 10001 blur_samples 1000001 }\n" + camera,
     "scene.txt:1:20: error: \"width\" out of range \"65537\"; expected a whole number from 1 to 65536\n"
     "scene.txt:1:33: error: \"height\" out of range \"1000000\"; expected a whole number from 1 to 65536\n"
     "scene.txt:1:51: error: \"recursion\" out of range \"10001\"; expected a whole number from 0 to 10000\n"
     "scene.txt:1:70: error: \"blur_samples\" out of range \"1000001\"; expected a whole number from 0 to 1000000\n"},
    {"flag", "sphere a { use_physics yes }\n" + camera,
     "scene.txt:1:24: error: not a number \"yes\"; expected 0 or 1\n"},
    {"flag_of_two", "sphere a { use_physics 2 }\n" + camera,
     "scene.txt:1:24: error: \"use_physics\" out of range \"2\"; expected 0 or 1\n"},
    {"ratio", "settings s { blur_switch_ratio 1.5 }\n" + camera,
     "scene.txt:1:32: error: \"blur_switch_ratio\" out of range \"1.5\"; expected a number from 0 to 1\n"},
    {"minus_one_is_a_plain_number_in_bodies", "box a { height 0 }\n" + camera,
     "scene.txt:1:16: error: \"height\" out of range \"0\"; expected a number other than 0\n"},
    {"undefined_reference", "material_phong Red { }\nsphere a { material Rde }\n" + camera,
     "scene.txt:2:21: error: undefined material \"Rde\"; expected the name of an element defined above; did you mean "
     "\"Red\"?\n"},
    {"reference_to_another_kind", "texture T { file a }\nmaterial_phong M { phong_info T }\n" + camera,
     "scene.txt:2:31: error: undefined phong_info \"T\"; expected the name of an element defined above\n"},
    {"reference_downwards", "material_phong M { phong_info P }\nphong_info P { }\n" + camera,
     "scene.txt:1:31: error: phong_info is defined only further down, at line 2 \"P\"; expected an element defined "
     "above\n"},
    {"texture_without_file", "texture T { }\n" + camera,
     "scene.txt:1:1: error: the texture has no \"file\" \"T\"; expected a file name\n"},
    {"event_attribute", "sphere a { add_force_event { forc { 1 0 0 } time 0 } }\n" + camera,
     "scene.txt:1:30: error: unknown attribute of add_force_event \"forc\"; did you mean \"force\"?\n"},
    {"event_in_a_box", "box a { add_force_event { force { 1 0 0 } time 0 } }\n" + camera,
     "scene.txt:1:9: error: unknown attribute of box \"add_force_event\"\n"},
    {"event_at_the_top", "add_force_event { force { 1 0 0 } }\n" + camera,
     "scene.txt:1:1: error: unknown element \"add_force_event\"; expected settings, camera, a material, a body or a "
     "light\n"},
    {"flat_box", "box a { vertex0 { 0 0 0 } vertex1 { 1 1 1 } vertex2 { 2 2 2 } }\n" + camera,
     "scene.txt:1:1: error: the base of the box has no area, or is too large \"a\"; expected vertex0, vertex1 "
     "and vertex2 that are not on one line\n"},
    {"relations_of_what_is_fine", "sphere a { radius x v_e { 0 0 1 } }\nsphere b { radius x v_e { 0 0 y } }\n" + camera,
     "scene.txt:1:19: error: not a number \"x\"; expected a number > 0\n"
     "scene.txt:2:19: error: not a number \"x\"; expected a number > 0\n"
     "scene.txt:2:31: error: not a number \"y\"; expected a number\n"
     "scene.txt:1:1: error: v_n is parallel to v_e \"[0, 0, 1]\"; expected a direction away from the axis "
     "[0, 0, 1]\n"},
    {"nothing_follows_from_defaults_of_unread_values",
     "camera C { add_position { nan 0 0 } add_target { 0 0 5 } }\nsphere a { v_m { 1 0 0 } v_n { 0 1 0 } }\n"
     "box b { vertex1 { 0 0 x } vertex2 { 2 0 0 } }\n",
     "scene.txt:1:27: error: not a number \"nan\"; expected a number\n"
     "scene.txt:2:12: error: unknown attribute of sphere \"v_m\"; did you mean \"v_e\"?\n"
     "scene.txt:3:23: error: not a number \"x\"; expected a number\n"},
    {"too_large",
     "sphere a { position { 0 -2e15 0 } radius 1e300 }\nphong_info p { diffuse_reflection 1e14 }\n" + camera,
     "scene.txt:1:25: error: \"position\" too large \"-2e15\"; expected a number of at most 1e+15 in size\n"
     "scene.txt:1:42: error: \"radius\" too large \"1e300\"; expected a number of at most 1e+15 in size\n"
     "scene.txt:2:35: error: \"diffuse_reflection\" too large \"1e14\"; expected a number of at most 1e+13 in size\n"},
    {"huge_box", "box a { vertex0 { -1e15 0 0 } vertex1 { 1e15 0 0 } }\n" + camera,
     "scene.txt:1:1: error: the base of the box has no area, or is too large \"a\"; expected vertex0, vertex1 and "
     "vertex2 that are not on one line\n"},
    {"names_of_the_file",
     "sphere a { v_e { 0 0 0 } }\nsphere b { v_n { 0 5 0 } }\nlight_rect c { x { 0 0 0 } }\n"
     "light_rect d { x { 0 0 3 } }\ncamera C { sky_start { 0 0 1 } }\n"
     "camera D { video_start 1 video_end 2 sky_start { 0 1 1 } sky_end { 0 0 0 } }\n"
     "camera E { video_start 2 video_end 3 sky_end { 0 0 1 } add_position { 0 0 9 } }\n",
     "scene.txt:1:16: error: v_e has no length \"[0, 0, 0]\"; expected a vector that is not zero\n"
     "scene.txt:2:16: error: v_n is parallel to v_e \"[0, 5, 0]\"; expected a direction away from the axis [0, 1, 0]\n"
     "scene.txt:3:18: error: x has no length \"[0, 0, 0]\"; expected a vector that is not zero\n"
     "scene.txt:4:1: error: light without area \"[0, 0, 1]\"; expected an edge that is not parallel to x [0, 0, 3]\n"
     "scene.txt:5:22: error: sky_start is parallel to the view \"[0, 0, 1]\"; expected a direction away from the view "
     "[0, 0, -5], for example [0, 1, 0]\n"
     "scene.txt:6:66: error: sky_end has no length \"[0, 0, 0]\"; expected a vector that is not zero\n"
     "scene.txt:7:46: error: sky_end is parallel to the view at the end \"[0, 0, 1]\"; expected a direction away from "
     "the view [0, 0, -9], for example [0, 1, 0]\n"},
    {"comment_hash", "# a comment of { words }\n" + camera,
     "scene.txt:1:1: error: the legacy format has no comments \"#\"; expected an element\n"},
    {"comment_slashes", "sphere a { // radius 2\n radius 1 }\n" + camera,
     "scene.txt:1:12: error: the legacy format has no comments \"//\"; expected an attribute\n"},
    {"utf16", std::string("\xFF\xFEs\0p\0", 6),
     "scene.txt:1:1: error: the file is UTF-16; expected UTF-8 (or "
     "Windows-1250) text\n"},
    {"binary", std::string("plane a { }\nxy\0z", 16),
     "scene.txt:2:3: error: not a text file: control character \"0x00\"; expected a legacy scene\n"},
    {"not_windows_1250", "plane \x81 { }",
     "scene.txt:1:7: error: neither UTF-8 nor Windows-1250 text \"0x81\"; "
     "expected a text file\n"},
};

INSTANTIATE_TEST_SUITE_P(All, LegacyErrors, testing::ValuesIn(cases),
                         [](const auto& param) { return std::string(param.param.name); });

// ---- places and spellings ------------------------------------------------------------------------------------------

TEST(LegacyNames, OfConvertedValues) {
    LegacyOptions options;
    options.legacy_step = 10;
    EXPECT_EQ(errors_of("sphere a { use_physics 1 add_force_event { force { 1e15 0 0 } } }\n" + camera, options),
              "scene.txt:1:50: error: force is too large \"[1e+16, 0, 0]\"; expected three numbers of at most 1e15 in "
              "size\n");
    options.fov = LegacyOptions::Fov::distance;
    EXPECT_EQ(errors_of("camera C { FOV_start 1e-300 FOV_end 1 }", options),
              "scene.txt:1:22: error: FOV_start gives an angle of view of 180 degrees \"1e-300\"; expected a larger "
              "number\n");
}

TEST(LegacyText, EveryLineEndingCountsLines) {
    for (const std::string end : {"\n", "\r\n", "\r"})
        EXPECT_EQ(errors_of("plane a {" + end + "}" + end + "\tspher b { }" + end + camera).substr(0, 16),
                  "scene.txt:3:2: e");
}

TEST(LegacyText, ByteOrderMarkIsNoColumn) {
    EXPECT_EQ(errors_of("\xEF\xBB\xBFspher b { }" + camera).substr(0, 16), "scene.txt:1:1: e");
}

TEST(LegacyText, ColumnsCountCharacters) {
    EXPECT_EQ(errors_of("sphere ko\xC5\x99"
                        "en { radius x }" +
                        camera)
                  .substr(0, 17),
              "scene.txt:1:23: e");
}

TEST(LegacyText, BracesTouchWords) {
    const SceneRead r = read("sphere a{position{1 2 3}radius 2}plane b{}camera C{add_position{0 0 5}}");
    EXPECT_EQ(r.scene.bodies.size(), 2u);
    EXPECT_EQ(std::get<Sphere>(r.scene.bodies[0].shape).center, (Vec3d{1, 2, 3}));
}

TEST(LegacyText, CzechCodePageOf2008) {
    const SceneRead r = read(
        "sphere sklen\xEC"
        "n\xE1_koule { }" +
        camera);  // Windows-1250
    EXPECT_EQ(r.scene.bodies[0].name, "sklen\xC4\x9Bn\xC3\xA1_koule");
    EXPECT_TRUE(legacy_test::says(r, "scene.txt:1:13: note: the file is not UTF-8; assumed: Windows-1250"))
        << legacy_test::notes_of(r);
}

TEST(LegacyText, NumbersAsStrtodTookThem) {
    const SceneRead r = read("sphere a { position { +1.5 .5 -2. } radius 1e-1 }" + camera);
    EXPECT_EQ(std::get<Sphere>(r.scene.bodies[0].shape), (Sphere{{1.5, 0.5, -2}, 0.1, {0, 1, 0}, {0, 0, 1}}));
}

TEST(LegacyText, BlankForUnderscoreAsInTheManual) {
    EXPECT_EQ(read("settings S { interpolate samples 2 }" + camera).scene.render.spp, 4);
}

// ---- hostile input -------------------------------------------------------------------------------------------------

TEST(LegacyHostile, MissingFilesAndFoldersAreAssetErrors) {
    for (const char* path : {"/nonexistent/scene.txt", "/"}) {
        try {
            read_legacy_scene(path);
            FAIL();
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::asset);
            EXPECT_EQ(std::string(e.what()).substr(0, std::string(path).size()), path);
        }
    }
}

/// Of this process alone, however busy the machine is.
double seconds_of(const std::string& text) {
    const std::clock_t start = std::clock();
    EXPECT_FALSE(errors_of(text).empty());
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

std::string repeated(const std::string& what, size_t bytes) {
    std::string out;
    while (out.size() < bytes) out += what;
    return out;
}

TEST(LegacyHostile, LargeNonsenseEndsSoon) {
    constexpr size_t size = size_t(4) << 20;  // the bound is 64 MB; the time is linear
    for (const char* what :
         {"{", "}", "a ", "sphere a {", "sphere a { position { 1 ", "x", "radius 1 ", "sphere ", "\n"})
        EXPECT_LT(seconds_of(repeated(what, size)), 1) << what;
    EXPECT_LT(seconds_of("sphere a { position {" + repeated(" nan", size)), 1);
    EXPECT_LT(seconds_of("sphere a { position {" + repeated(" 1", size)), 1);
    EXPECT_LT(seconds_of("sphere a { junk " + repeated("{ ", size)), 1);
}

TEST(LegacyHostile, ErrorsAreCapped) {
    const std::string errors = errors_of(repeated("spher a { }\n", 12 * 1000));
    EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 101);
    EXPECT_NE(errors.find("scene.txt:101:1: error: more errors follow; the first 100 are shown\n"), std::string::npos);
}

TEST(LegacyHostile, LongWordsAreCutInMessages) {
    EXPECT_LT(errors_of(repeated("\xC5\x99", 100000) + " b { }" + camera).size(), 300u);
}

TEST(LegacyHostile, OversizedFilesAreRefused) {
    try {
        read_legacy_scene("/dev/zero");
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::scene);
        EXPECT_STREQ(e.what(), "/dev/zero: error: the scene is larger than 64 MB");
    }
}

// Mutants of a scene that uses everything: each is read, or refused with located errors. Nothing else may happen.
TEST(LegacyHostile, MutantsAreReadOrRefused) {
    const std::string seed =
        "settings S { width 640 height 480 fps 2 blur_samples 32 blur_duration -1 dof_samples 18 dof_c 0.2 }\n"
        "camera C { video_end 8 add_position { 0 0 5 } add_position { 0 1 5 } add_target { 0 0 0 } FOV_start 2.5 }\n"
        "phong_info P { ambient { 0.6 0 0 } shininess 20 }\ntexture T { filename t.tga }\n"
        "material_texture M { phong_info P texture T scale_U 0.5 }\nmaterial_phong M { phong_info P }\n"
        "sphere B { position { 1 2 3 } radius 4 material M use_physics 1 add_force_event { force { 1 0 0 } time 0.1 } "
        "}\n"
        "box G { vertex1 { 2 0 0 } vertex2 { 2 0 1 } height 5 }\nlight_rect L { x { 1 0 0 } y { 0 1 0 } }\n";
    const std::string_view parts[] = {"{",      "}", " ",  "-1",   "nan",      "1e308",
                                      "sphere", "M", "\n", "\xFF", "material", "0"};
    std::mt19937 rng(2008);
    const auto below = [&rng](size_t n) { return size_t(rng() % n); };
    int good = 0, bad = 0;
    for (int i = 0; i < 4000; ++i) {
        std::string text = seed;
        for (size_t n = 1 + below(4); n > 0; --n) {
            const size_t at = below(text.size());
            switch (below(4)) {
                case 0:
                    text.erase(at, 1 + below(8));
                    break;
                case 1:
                    text.insert(at, parts[below(std::size(parts))]);
                    break;
                case 2:
                    text[at] = char(32 + below(95));
                    break;
                case 3:
                    text.insert(at, text.substr(below(text.size()), below(40)));
                    break;
            }
        }
        try {
            const SceneRead r = read(text);
            EXPECT_FALSE(has_errors(r.notes));
            ++good;
        } catch (const Error& e) {
            EXPECT_EQ(e.kind(), ErrorKind::scene);
            EXPECT_TRUE(has_errors(e.diagnostics()));
            ++bad;
        }
    }
    EXPECT_GT(good, 50);
    EXPECT_GT(bad, 1000);
}

}  // namespace
}  // namespace drt
