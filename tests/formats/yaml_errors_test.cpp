// Bad YAML files and the whole of what is said of each: file:line:column, the offending text, what was expected.
#include <gtest/gtest.h>

#include <chrono>

#include "drt/formats/formats.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

struct Case {
    std::string name;
    std::string text;
    std::string messages;
};
std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

const std::string head = "drt: 1\ncameras: [{}]\n";

class YamlErrors : public testing::TestWithParam<Case> {};

TEST_P(YamlErrors, SaysWhatIsWrongAndWhere) {
    const TemporaryFiles files;
    const std::string path = files.write("bad.yaml", GetParam().text);
    try {
        read_yaml_scene(path);
        FAIL() << "was read";
    } catch (const Error& e) {
        EXPECT_EQ(e.kind(), ErrorKind::scene);
        EXPECT_EQ(files.without_folder(e.what()), GetParam().messages);
    }
}

// ---- the file as a whole, its keys and aliases

const std::vector<Case> document_cases{
    {"empty_file", "", "bad.yaml: error: the file is empty; expected `drt: 1` and a scene"},
    {"only_comments", "# nothing\n", "bad.yaml: error: the file is empty; expected `drt: 1` and a scene"},
    {"null_document",
     "---\n"
     "...\n",
     "bad.yaml:2:1: error: the file is not a mapping; expected `drt: 1` and a scene"},
    {"a_list", "- drt: 1\n", "bad.yaml:1:1: error: the file is not a mapping; expected `drt: 1` and a scene"},
    {"a_text", "hello\n", "bad.yaml:1:1: error: the file is not a mapping \"hello\"; expected `drt: 1` and a scene"},
    {"no_version", "cameras: [{}]\n",
     "bad.yaml:1:1: error: missing key \"drt\"; expected `drt: 1`, the version of this format"},
    {"future_version",
     "drt: 2\n"
     "camerass: []\n",
     "bad.yaml:1:6: error: a version of the format that this program does not know \"2\"; expected `drt: 1`, the "
     "version of this format"},
    {"version_as_list", "drt: [1]\n",
     "bad.yaml:1:6: error: a version of the format that this program does not know; expected `drt: 1`, the version of "
     "this format"},
    {"two_documents",
     head + "---\n"
            "drt: 1\n",
     "bad.yaml:3:1: error: a second document starts here \"---\"; expected one document; are lines indented as those "
     "above?"},
    {"unindented_list",
     "- a\n"
     "b: 1\n",
     "bad.yaml:2:1: error: a second document starts here \"b: 1\"; expected one document; are lines indented as those "
     "above?"},
    {"duplicate_key",
     head + "render:\n"
            "  width: 10\n"
            "  spp: 4\n"
            "  width: 20\n",
     "bad.yaml:6:3: error: duplicate key \"width\"; expected it once; it was first used in line 4"},
    {"duplicate_section",
     head + "lights: []\n"
            "lights: []\n",
     "bad.yaml:4:1: error: duplicate key \"lights\"; expected it once; it was first used in line 3"},
    {"merge_key",
     head + "render: &r {spp: 4}\n"
            "materials:\n"
            "  - <<: *r\n"
            "    name: red\n",
     "bad.yaml:5:5: error: merge keys are not supported \"<<\"; expected the keys themselves"},
    {"self_alias", head + "render: &r [*r]\n",
     "bad.yaml:3:13: error: an alias of the very list or mapping that it stands in \"*r\"; expected an alias of "
     "something complete"},
    {"self_alias_deep",
     head + "render: &r\n"
            "  filter:\n"
            "    kind: *r\n",
     "bad.yaml:5:11: error: an alias of the very list or mapping that it stands in \"*r\"; expected an alias of "
     "something complete"},
    {"unknown_alias", head + "render: *nope\n",
     "bad.yaml:3:9: error: an alias of nothing \"*nope\"; expected the name of an anchor above"},
    {"tag", head + "render: {width: !!float 3, height: !pixels 4}\n",
     "bad.yaml:3:17: error: tags are not supported \"!!float\"; expected a value without a tag\n"
     "bad.yaml:3:36: error: tags are not supported \"!pixels\"; expected a value without a tag"},
    {"key_is_a_list",
     head + "? [1, 2]\n"
            ": 3\n",
     "bad.yaml:3:3: error: a key that is not a word; expected a word"},
    {"yaml_version",
     "%YAML 3.0\n"
     "---\n"
     "drt: 1\n",
     "bad.yaml:1:1: error: not YAML: YAML major version too large \"%YAML 3.0\"; expected YAML 1.2"},
};

// ---- YAML's grammar

const std::vector<Case> syntax_cases{
    {"unclosed_double_quote",
     head + "materials:\n"
            "  - name: \"red\n"
            "    shininess: 3\n",
     "bad.yaml:4:11: error: a quote that is never closed \"\"red\"; expected a closing \""},
    {"unclosed_single_quote",
     head + "materials:\n"
            "  - name: 'red\n"
            "    shininess: 3\n",
     "bad.yaml:4:11: error: a quote that is never closed \"'red\"; expected a closing '"},
    {"quote_over_lines",
     head + "materials:\n"
            "  - name: \"red\n"
            "    shininess: 3\n"
            "  - name: \"blue\"\n",
     "bad.yaml:4:11: note: a text in quotes that starts here ends on a later line; expected its closing quote on this "
     "line\n"
     "bad.yaml:6:12: error: a mapping does not go on like this \"blue\"\"; expected `key: value`, each on its own "
     "line, indented as its neighbours"},
    {"unclosed_bracket",
     head + "gravity: [0, -9.81, 0\n"
            "ambient_light: 1\n",
     "bad.yaml:4:14: error: a list in brackets does not go on like this \": 1\"; expected ',' or ']'"},
    {"unclosed_brace",
     head + "render: {width: 10\n"
            "ambient_light: 1\n",
     "bad.yaml:4:14: error: a mapping in braces does not go on like this \": 1\"; expected ',' or '}'"},
    {"closing_bracket", head + "gravity: ]\n",
     "bad.yaml:3:10: error: a closing bracket without an opening one \"]\"; expected a value"},
    {"missing_comma", head + "render: {width: 10 height: 20}\n",
     "bad.yaml:3:26: error: a mapping in braces does not go on like this \": 20}\"; expected ',' or '}'"},
    {"two_colons", head + "render: width: 10\n",
     "bad.yaml:3:14: error: a value cannot begin here \": 10\"; expected `key: value`, each on its own line, indented "
     "as its neighbours"},
    {"bad_indentation",
     head + "render:\n"
            "  width: 10\n"
            "   height: 20\n",
     "bad.yaml:5:10: error: a value cannot begin here \": 20\"; expected `key: value`, each on its own line, indented "
     "as its neighbours"},
    {"missing_colon",
     head + "render:\n"
            "  width 10\n"
            "  height: 20\n",
     "bad.yaml:5:9: error: a value cannot begin here \": 20\"; expected `key: value`, each on its own line, indented "
     "as its neighbours"},
    {"tabs",
     head + "render:\n"
            "\x09width: 10\n"
            "  height: 20\n"
            "materials:\n"
            " - name: red\n"
            " \x09shininess: 3\n",
     "bad.yaml:4:1: error: a tab in the indentation \"\\x09width: 10\"; expected spaces\n"
     "bad.yaml:8:2: error: a tab in the indentation \"\\x09shininess: 3\"; expected spaces"},
    {"at_sign",
     head + "materials:\n"
            "  - name: @home\n",
     "bad.yaml:4:11: error: no value can begin with this character \"@home\"; expected the value in quotes"},
    {"bad_escape",
     head + "materials:\n"
            "  - name: \"C:\\qux\"\n",
     "bad.yaml:4:16: error: an unknown escape in double quotes before this \"ux\"\"; expected \\\\ for a backslash, or "
     "single quotes"},
    {"text_after_quote",
     head + "materials:\n"
            "  - name: \"red\" paint\n",
     "bad.yaml:4:17: error: a mapping does not go on like this \"paint\"; expected `key: value`, each on its own line, "
     "indented as its neighbours"},
};

// ---- bytes that are not text

const std::vector<Case> encoding_cases{
    {"latin_1",
     head + "materials:\n"
            "  - name: \"m\\xed\\u010d caf\xe9\"\n",
     "bad.yaml:4:27: error: a byte that is not UTF-8 \"\\xe9\"; expected UTF-8 text"},
    {"utf_16",
     std::string("\xff\xfe"
                 "d\0r\0t\0",
                 8),
     "bad.yaml:1:1: error: the file is not UTF-8 but looks like UTF-16; expected UTF-8 text"},
    {"utf_16_without_mark",
     std::string("d\0r\0t\0:\0 \0"
                 "1\0",
                 12),
     "bad.yaml:1:1: error: the file is not UTF-8 but looks like UTF-16; expected UTF-8 text"},
    {"control_character",
     head + "materials:\n"
            "  - name: \"bell \x07\"\n",
     "bad.yaml:4:17: error: a control character \"\\x07\"; expected text"},
};

// ---- what a number may look like

const std::vector<Case> number_cases{
    {"nan", head + "render: {fps: .nan}\n", "bad.yaml:3:15: error: fps is not finite \".nan\"; expected a number > 0"},
    {"infinity", head + "render: {fps: -.inf}\n",
     "bad.yaml:3:15: error: fps is not finite \"-.inf\"; expected a number > 0"},
    {"nan_words", head + "gravity: [nan, inf, -Infinity]\n",
     "bad.yaml:3:11: error: gravity is not finite \"nan\"; expected a number\n"
     "bad.yaml:3:16: error: gravity is not finite \"inf\"; expected a number\n"
     "bad.yaml:3:21: error: gravity is not finite \"-Infinity\"; expected a number"},
    {"overflow", head + "render: {fps: 1e400}\n",
     "bad.yaml:3:15: error: fps does not fit into a floating-point number \"1e400\"; expected a number > 0"},
    {"underflow", head + "render: {fps: 1e-400}\n",
     "bad.yaml:3:15: error: fps does not fit into a floating-point number \"1e-400\"; expected a number > 0"},
    {"colour_overflow", head + "background: 1e39\n",
     "bad.yaml:3:13: error: background does not fit into a floating-point number \"1e39\"; expected [r, g, b], one "
     "number for a grey, or \"#rrggbb\" in quotes"},
    {"underscores", head + "render: {width: 1_000}\n",
     "bad.yaml:3:17: error: width is not a number \"1_000\"; expected an integer >= 1 and <= 65536; did you mean "
     "\"1000\"?"},
    {"decimal_comma",
     head + "render:\n"
            "  fps: 1,5\n",
     "bad.yaml:4:8: error: fps is not a number \"1,5\"; expected a number > 0; did you mean \"1.5\"?"},
    {"decimal_comma_in_braces", head + "render: {fps: 1,5}\n",
     "bad.yaml:3:17: error: unknown key \"5\"; expected a point, not a comma, in a decimal number"},
    {"comma_in_vector", head + "gravity: [0, -9,81, 0]\n",
     "bad.yaml:3:10: error: gravity has 4 components; expected [x, y, z]"},
    {"octal", head + "render: {width: 010}\n",
     "bad.yaml:3:17: error: width has a leading zero \"010\"; expected an integer >= 1 and <= 65536; did you mean "
     "\"10\"?"},
    {"new_octal", head + "render: {width: 0o10}\n",
     "bad.yaml:3:17: error: width is not a number \"0o10\"; expected an integer >= 1 and <= 65536; did you mean "
     "\"8\"?"},
    {"hexadecimal", head + "render: {width: 0x10, fps: 0x1F}\n",
     "bad.yaml:3:17: error: width is not a number \"0x10\"; expected an integer >= 1 and <= 65536; did you mean "
     "\"16\"?\n"
     "bad.yaml:3:28: error: fps is not a number \"0x1F\"; expected a number > 0; did you mean \"31\"?"},
    {"unit", head + "render: {fps: 1.5abc}\n",
     "bad.yaml:3:15: error: fps is not a number \"1.5abc\"; expected a number > 0"},
    {"number_in_quotes", head + "render: {width: \"10\"}\n",
     "bad.yaml:3:17: error: width is a text in quotes \"10\"; expected an integer >= 1 and <= 65536"},
    {"empty_text", head + "render: {width: \"\"}\n",
     "bad.yaml:3:17: error: width is a text in quotes; expected an integer >= 1 and <= 65536"},
    {"tilde", head + "render: {width: ~}\n",
     "bad.yaml:3:10: error: width has no value; expected an integer >= 1 and <= 65536"},
    {"no_value",
     head + "render:\n"
            "  width:\n"
            "  height: 20\n",
     "bad.yaml:4:3: error: width has no value; expected an integer >= 1 and <= 65536"},
    {"null_list", head + "bodies:\n",
     "bad.yaml:3:1: error: bodies has no value; expected a list: `- ` before each item, or [] for none"},
    {"fraction", head + "render: {width: 10.5}\n",
     "bad.yaml:3:17: error: width is not a whole number \"10.5\"; expected an integer >= 1 and <= 65536"},
    {"beyond_int", head + "render: {spp: 1e10}\n",
     "bad.yaml:3:15: error: spp is out of range \"1e10\"; expected an integer >= 1 and <= 16777216"},
    {"negative_seed", head + "render: {seed: -1}\n",
     "bad.yaml:3:16: error: seed is out of range \"-1\"; expected an integer >= 0 and <= 4294967295"},
    {"seed_too_large", head + "render: {seed: 4294967296}\n",
     "bad.yaml:3:16: error: seed is out of range \"4294967296\"; expected an integer >= 0 and <= 4294967295"},
};

// ---- values of the wrong kind

const std::vector<Case> kind_cases{
    {"list_for_number", head + "render: {width: [1]}\n",
     "bad.yaml:3:17: error: width is a list; expected an integer >= 1 and <= 65536"},
    {"mapping_for_number", head + "render: {width: {pixels: 1}}\n",
     "bad.yaml:3:17: error: width is a mapping; expected an integer >= 1 and <= 65536"},
    {"number_for_mapping", head + "render: 5\n",
     "bad.yaml:3:9: error: render is a single value \"5\"; expected the keys of render"},
    {"mapping_for_list",
     head + "materials:\n"
            "  name: red\n",
     "bad.yaml:4:3: error: materials is a mapping; expected a list: `- ` before each item, or [] for none"},
    {"text_for_item", head + "materials: [red]\n",
     "bad.yaml:3:13: error: materials is a single value \"red\"; expected the keys of material"},
    {"two_components", head + "gravity: [0, -9.81]\n",
     "bad.yaml:3:10: error: gravity has 2 components; expected [x, y, z]"},
    {"number_for_vector", head + "gravity: -9.81\n",
     "bad.yaml:3:10: error: gravity is a single value \"-9.81\"; expected [x, y, z]"},
    {"bad_component", head + "gravity: [0, down, x]\n",
     "bad.yaml:3:14: error: gravity is not a number \"down\"; expected a number\n"
     "bad.yaml:3:20: error: gravity is not a number \"x\"; expected a number"},
    {"yes",
     head + "lights:\n"
            "  - {type: rectangle, visible: yes, two_sided: 1}\n",
     "bad.yaml:4:32: error: visible is neither true nor false \"yes\"; expected true or false\n"
     "bad.yaml:4:48: error: two_sided is neither true nor false \"1\"; expected true or false"},
    {"colour_name", head + "background: red\n",
     "bad.yaml:3:13: error: background is not a number \"red\"; expected [r, g, b], one number for a grey, or "
     "\"#rrggbb\" in quotes"},
    {"colour_digits", head + "background: \"#12345\"\n",
     "bad.yaml:3:13: error: background is not a colour \"#12345\"; expected [r, g, b], one number for a grey, or "
     "\"#rrggbb\" in quotes"},
    {"colour_comment", head + "background: #123456\n",
     "bad.yaml:3:1: error: background has no value; expected [r, g, b], one number for a grey, or \"#rrggbb\" in "
     "quotes"},
    {"list_for_name", head + "materials: [{name: [red]}]\n", "bad.yaml:3:20: error: name is a list; expected a name"},
    {"orientation_keys",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - {type: box, material: m, orientation: {axis: [0, 1, 0], degree: 90}}\n"
            "  - {type: box, material: m, orientation: {axis: [0, 0, 0], degrees: 90}}\n"
            "  - {type: box, material: m, orientation: [1, 0, 0]}\n"
            "  - {type: box, material: m, orientation: {degrees: x, axis: 1}}\n",
     "bad.yaml:5:43: error: missing key \"degrees\"; expected [w, x, y, z] or {axis: [x, y, z], degrees: d}\n"
     "bad.yaml:5:61: error: unknown key \"degree\"; expected [w, x, y, z] or {axis: [x, y, z], degrees: d}; did you "
     "mean \"degrees\"?\n"
     "bad.yaml:6:50: error: axis has no usable length \"[0, 0, 0]\"; expected a vector that is not zero\n"
     "bad.yaml:7:43: error: orientation has 3 components; expected [w, x, y, z] or {axis: [x, y, z], degrees: d}\n"
     "bad.yaml:8:53: error: degrees is not a number \"x\"; expected a number\n"
     "bad.yaml:8:62: error: axis is a single value \"1\"; expected [x, y, z]"},
};

// ---- keys that are unknown, missing, or do not go together

const std::vector<Case> key_cases{
    {"unknown_key", head + "render: {widht: 10, spq: 5, antialiasing: 3}\n",
     "bad.yaml:3:10: error: unknown key \"widht\"; expected a key of render; did you mean \"width\"?\n"
     "bad.yaml:3:21: error: unknown key \"spq\"; expected a key of render; did you mean \"spp\"?\n"
     "bad.yaml:3:29: error: unknown key \"antialiasing\"; expected a key of render: width, height, fps, spp, seed, "
     "max_depth, filter, transparent_background"},
    {"unknown_section", head + "matrials: []\n",
     "bad.yaml:3:1: error: unknown key \"matrials\"; expected a key of scene; did you mean \"materials\"?"},
    {"prefix_of_key",
     "drt: 1\n"
     "cameras: [{fov: 40}]\n",
     "bad.yaml:2:12: error: unknown key \"fov\"; expected a key of camera; did you mean \"fov_degrees\"?"},
    {"missing_type",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - material: m\n"
            "    radius: 3\n",
     "bad.yaml:5:5: error: missing key \"type\"; expected `type: ...`, one of plane, sphere, triangle, rectangle, "
     "parallelogram, box, cylinder, disc, sphere_set"},
    {"unknown_type",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - {type: shpere, material: m, radius: 3, foo: 1}\n",
     "bad.yaml:5:12: error: unknown type \"shpere\"; expected one of plane, sphere, triangle, rectangle, "
     "parallelogram, box, cylinder, disc, sphere_set; did you mean \"sphere\"?\n"
     "bad.yaml:5:44: error: unknown key \"foo\"; expected a key of body: name, type, material, priority, motion, "
     "physics, "
     "position, normal, center, radius, pole, meridian, vertex0, vertex1, vertex2, corner, edge0, edge1, size, "
     "orientation, from, to, capped, file"},
    {"key_of_another_shape",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - {type: box, material: m, radius: 3}\n",
     "bad.yaml:5:30: error: unknown key \"radius\"; expected a key of body box: name, type, material, priority, "
     "motion, physics, "
     "center, size, orientation"},
    {"missing_keys",
     head + "materials: [{}]\n"
            "textures: [{name: t}]\n"
            "bodies: [{type: sphere_set}]\n",
     "bad.yaml:3:13: error: missing key \"name\"; expected `name: ...`, bodies refer to it\n"
     "bad.yaml:4:12: error: missing key \"file\"; expected `file: ...`, any type that OpenImageIO reads\n"
     "bad.yaml:5:10: error: missing key \"file\"; expected `file: ...`, text file, `x y z radius` on each line\n"
     "bad.yaml:5:10: error: missing key \"material\"; expected `material: ...`, what it is made of"},
    {"unknown_word",
     head + "render: {filter: {kind: gausian}}\n"
            "lights: [{type: point, falloff: linear}]\n",
     "bad.yaml:3:25: error: unknown kind \"gausian\"; expected one of point, box, triangle, gaussian, blackman_harris, "
     "mitchell; did you mean \"gaussian\"?\n"
     "bad.yaml:4:33: error: unknown falloff \"linear\"; expected one of none, inverse_square"},
    {"filter_as_word", head + "render: {filter: gaussian}\n",
     "bad.yaml:3:18: error: filter is a single value \"gaussian\"; expected the keys of filter"},
    {"singular_and_plural",
     "drt: 1\n"
     "cameras:\n"
     "  - position: [0, 0, 9]\n"
     "    positions: [[0, 0, 9], [0, 1, 9]]\n"
     "    video_end: 1\n",
     "bad.yaml:4:16: error: positions beside position; expected one of the two"},
    {"start_and_stop",
     "drt: 1\n"
     "cameras:\n"
     "  - fov_degrees: {start: 40, stop: 50}\n"
     "    video_end: 1\n",
     "bad.yaml:3:30: error: unknown key \"stop\"; expected a key of fov_degrees: start, end"},
    {"list_in_singular",
     "drt: 1\n"
     "cameras:\n"
     "  - position: [[0, 0, 9], [0, 1, 9]]\n",
     "bad.yaml:3:15: error: position has 2 components; expected [x, y, z]"},
    {"first_key_without_position",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - type: sphere\n"
            "    material: m\n"
            "    motion:\n"
            "      keys:\n"
            "        - {time: 0}\n"
            "        - {position: [1, 2, 3]}\n",
     "bad.yaml:9:11: error: missing key \"position\"; expected `position: ...`, where the body's centre (the camera's "
     "eye) is\n"
     "bad.yaml:10:11: error: missing key \"time\"; expected `time: ...`, scene time; ascending from key to key"},
    {"motion_as_list",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - type: sphere\n"
            "    material: m\n"
            "    motion:\n"
            "      - {time: 0, position: [1, 2, 3]}\n",
     "bad.yaml:8:7: error: motion is a list; expected the keys of motion"},
};

// ---- values that validate() refuses, at their places

const std::vector<Case> value_cases{
    {"range",
     head + "materials:\n"
            "  - name: glass\n"
            "    refraction_index: 0\n"
            "bodies:\n"
            "  - type: sphere\n"
            "    radius: -1\n"
            "    material: glas\n",
     "bad.yaml:5:23: error: refraction_index is out of range \"0\"; expected a number > 0\n"
     "bad.yaml:8:13: error: radius is out of range \"-1\"; expected a number > 0\n"
     "bad.yaml:9:15: error: unknown material \"glas\"; expected the name of a material; did you mean \"glass\"?"},
    {"orientation_beside_turn",
     "drt: 1\n"
     "cameras:\n"
     "  - motion:\n"
     "      keys:\n"
     "        - {time: 0, position: [0, 0, 5], turn: {degrees: 9}, orientation: [1, 0, 0, 0]}\n"
     "        - {time: 1, orientation: [1, 0, 0, 0], turn: {degrees: 90}}\n"
     "        - {time: 2, orientation: {axis: [0, 1, 0], degrees: 9}, turn: {degrees: 90}}\n"
     "        - {time: 3, turn: {degrees: 90}}\n"
     "        - {time: 4, orientation: {axis: [0, 1, 0], degrees: 9}}\n",
     "bad.yaml:5:48: error: turn beside orientation; expected one of the two\n"
     "bad.yaml:6:54: error: turn beside orientation; expected one of the two\n"
     "bad.yaml:7:71: error: turn beside orientation; expected one of the two"},
    {"zoom_and_end",
     "drt: 1\n"
     "cameras:\n"
     "  - fov_degrees: {start: 40, end: 20}\n"
     "    zoom: image_widht\n"
     "    video_end: 4\n"
     "    video_end_inclusive: 1\n",
     "bad.yaml:4:11: error: unknown zoom \"image_widht\"; expected one of angle, image_width, focal_length; did you "
     "mean \"image_width\"?\n"
     "bad.yaml:6:26: error: video_end_inclusive is neither true nor false \"1\"; expected true or false"},
    {"zero_fov",
     "drt: 1\n"
     "cameras:\n"
     "  - fov_degrees: 0\n"
     "  - fov_degrees: {start: 40, end: 200}\n"
     "    video_start: 3\n"
     "    video_end: 4\n",
     "bad.yaml:3:18: error: fov_degrees is out of range \"0\"; expected a number > 0 and < 180\n"
     "bad.yaml:4:35: error: fov_degrees is out of range \"200\"; expected a number > 0 and < 180"},
    {"up",
     "drt: 1\n"
     "cameras:\n"
     "  - position: [0, 9, 0]\n"
     "    up: [0, 1, 0]\n",
     "bad.yaml:4:9: error: up is parallel to the view \"[0, 1, 0]\"; expected a direction away from the view [0, -9, "
     "0], for example [0, 0, 1]"},
    {"far_coordinate",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - {type: sphere, material: m, center: [0, 2e15, 0]}\n",
     "bad.yaml:5:41: error: center is too large \"[0, 2e+15, 0]\"; expected three numbers of at most 1e15 in size"},
    {"key_times",
     head + "materials: [{name: m}]\n"
            "bodies:\n"
            "  - type: sphere\n"
            "    material: m\n"
            "    motion:\n"
            "      keys:\n"
            "        - {time: 0, position: [1, 2, 3]}\n"
            "        - {time: 0}\n",
     "bad.yaml:10:18: error: key times do not ascend \"0\"; expected more than the previous key's 0"},
    {"physics",
     head + "units: 0\n"
            "simulation: {start: 1, end: 0, tolerance: 0}\n"
            "materials: [{name: m}]\n"
            "bodies:\n"
            "  - type: sphere\n"
            "    material: m\n"
            "    physics:\n"
            "      mass: 1e300\n"
            "      restitution: 2\n"
            "      impulses:\n"
            "        - {time: 1, force: [1, 0, 0]}\n"
            "      forces:\n"
            "        - {from: 2, until: 1, force: [1, 0, .inf]}\n"
            "  - type: plane\n"
            "    material: m\n"
            "    physics: {kind: fixed}\n"
            "  - {type: plane, material: m, physics: {}}\n"
            "  - {type: disc, material: m, physics: {kind: dynamic}}\n"
            "  - {type: box, material: m, physics: {mass: 1, density: 1}, motion: {keys: [{time: 0, position: [0, 0, "
            "0]}]}}\n",
     "bad.yaml:3:8: error: units is out of range \"0\"; expected a number > 0\n"
     "bad.yaml:4:29: error: the simulation ends before it starts \"0\"; expected more than start 1\n"
     "bad.yaml:4:43: error: tolerance is out of range \"0\"; expected a number > 0\n"
     "bad.yaml:10:13: error: mass is too large \"1e+300\"; expected a number of at most 1e15 in size\n"
     "bad.yaml:11:20: error: restitution is out of range \"2\"; expected a number >= 0 and <= 1\n"
     "bad.yaml:13:11: error: missing key \"impulse\"; expected `impulse: ...`, direction and size\n"
     "bad.yaml:13:21: error: unknown key \"force\"; expected a key of impulse: time, impulse, at\n"
     "bad.yaml:15:28: error: the force ends before it begins \"1\"; expected more than from 2\n"
     "bad.yaml:15:45: error: force is not finite \".inf\"; expected a number\n"
     "bad.yaml:18:21: error: unknown kind \"fixed\"; expected one of dynamic, static, kinematic\n"
     "bad.yaml:19:41: error: an infinite plane cannot move \"dynamic\"; expected static\n"
     "bad.yaml:20:47: error: a disc cannot be dynamic, for it has no volume \"dynamic\"; expected static or kinematic; "
     "or a shape that has one: sphere, box, cylinder\n"
     "bad.yaml:21:58: error: density beside mass \"1\"; expected one of the two\n"
     "bad.yaml:21:70: error: a dynamic body cannot have a motion: its motion is what is simulated; expected no motion, "
     "or kind: kinematic"},
    {"absurd_size",
     head + "render:\n"
            "  width: 1000000\n"
            "  height: 0\n",
     "bad.yaml:4:10: error: width is out of range \"1000000\"; expected an integer >= 1 and <= 65536\n"
     "bad.yaml:5:11: error: height is out of range \"0\"; expected an integer >= 1 and <= 65536"},
    {"no_camera", "drt: 1\n", "bad.yaml: error: the scene has no camera; expected at least one"},
    {"everything_at_once",
     "drt: 1\n"
     "render:\n"
     "  widht: 10\n"
     "  spp: many\n"
     "materials:\n"
     "  - name: red\n"
     "    shininess: -3\n"
     "bodies:\n"
     "  - type: sphere\n"
     "    material: rde\n"
     "    radius: 1,5\n"
     "  - type: cube\n"
     "lights:\n"
     "  - {type: point, visible: true}\n"
     "cameras:\n"
     "  - fov_degrees: 180\n",
     "bad.yaml:3:3: error: unknown key \"widht\"; expected a key of render; did you mean \"width\"?\n"
     "bad.yaml:4:8: error: spp is not a number \"many\"; expected an integer >= 1 and <= 16777216\n"
     "bad.yaml:7:16: error: shininess is out of range \"-3\"; expected a number >= 0\n"
     "bad.yaml:10:15: error: unknown material \"rde\"; expected the name of a material; did you mean \"red\"?\n"
     "bad.yaml:11:13: error: radius is not a number \"1,5\"; expected a number > 0; did you mean \"1.5\"?\n"
     "bad.yaml:12:5: error: missing key \"material\"; expected `material: ...`, what it is made of\n"
     "bad.yaml:12:11: error: unknown type \"cube\"; expected one of plane, sphere, triangle, rectangle, parallelogram, "
     "box, cylinder, disc, sphere_set\n"
     "bad.yaml:14:28: error: a point light cannot be seen \"true\"; expected false, or a small light of type sphere\n"
     "bad.yaml:16:18: error: fov_degrees is out of range \"180\"; expected a number > 0 and < 180"},
};

// ---- several faults of one thing: each is told, none twice

const std::vector<Case> together_cases{
    {"unread_position",
     "drt: 1\n"
     "cameras:\n"
     "  - {position: [.nan, 0, 0], target: [0, 0, 5], fov_degrees: 200}\n"  // position's default
     "  - {name: b, position: [0, 0, 1], target: [0, 0, 1], video_end: x, fov_degrees: y}\n",
     "bad.yaml:3:17: error: position is not finite \".nan\"; expected a number\n"
     "bad.yaml:3:62: error: fov_degrees is out of range \"200\"; expected a number > 0 and < 180\n"
     "bad.yaml:4:44: error: the camera's target is its position \"[0, 0, 1]\"; expected a point away from the eye "
     "[0, 0, 1]\n"
     "bad.yaml:4:66: error: video_end is not a number \"x\"; expected a number\n"
     "bad.yaml:4:82: error: fov_degrees is not a number \"y\"; expected a number > 0 and < 180"},
    {"unread_list",
     "drt: 1\n"
     "cameras:\n"
     "  - targets: 5\n",
     "bad.yaml:3:14: error: targets is a single value \"5\"; expected a list: `- ` before each item, or [] for none"},
    {"unread_edge",
     head + "lights:\n"
            "  - {type: rectangle, color: -1, edge_x: [1, 0, 0], edge_y: [2, 0, 0]}\n"
            "  - {type: rectangle, color: -1, edge_x: [0, 0, x], edge_y: [2, 0, 0]}\n",
     "bad.yaml:4:30: error: color is out of range \"-1\"; expected a colour of numbers >= 0\n"
     "bad.yaml:4:61: error: light without area \"[2, 0, 0]\"; expected an edge that is not parallel to edge_x [1, 0, "
     "0]\n"
     "bad.yaml:5:30: error: color is out of range \"-1\"; expected a colour of numbers >= 0\n"
     "bad.yaml:5:49: error: edge_x is not a number \"x\"; expected a number"},
};

std::string case_name(const testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Document, YamlErrors, testing::ValuesIn(document_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Syntax, YamlErrors, testing::ValuesIn(syntax_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Encoding, YamlErrors, testing::ValuesIn(encoding_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Numbers, YamlErrors, testing::ValuesIn(number_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Kinds, YamlErrors, testing::ValuesIn(kind_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Keys, YamlErrors, testing::ValuesIn(key_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Values, YamlErrors, testing::ValuesIn(value_cases), case_name);
INSTANTIATE_TEST_SUITE_P(Together, YamlErrors, testing::ValuesIn(together_cases), case_name);

}  // namespace
}  // namespace drt
