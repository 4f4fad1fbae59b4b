// docs/scene-format.md against the reader. DRT_UPDATE_DOCS=1 makes the first test write the page's tables anew.
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "drt/formats/formats.h"
#include "formats/scene_reference.h"
#include "formats/temporary_files.h"

namespace drt {
namespace {

const std::string page = DRT_SOURCE_DIR "/docs/scene-format.md";
const std::string end_mark = "<!-- end of fields -->";

std::string load_page() {
    std::ostringstream out;
    out << std::ifstream(page, std::ios::binary).rdbuf();
    return out.str();
}

std::string start_mark(const std::string& title) { return "<!-- fields of " + title + " -->\n"; }

TEST(SceneDocs, TablesAreThoseOfTheReader) {
    std::string text = load_page();
    ASSERT_FALSE(text.empty()) << page;
    const bool update = std::getenv("DRT_UPDATE_DOCS") != nullptr;
    for (const auto& [title, table] : scene_reference()) {
        const std::size_t mark = text.find(start_mark(title));
        ASSERT_NE(mark, std::string::npos) << page << " lacks the line " << start_mark(title);
        const std::size_t begin = mark + start_mark(title).size(), end = text.find(end_mark, begin);
        ASSERT_NE(end, std::string::npos);
        if (update)
            text.replace(begin, end - begin, table);
        else
            EXPECT_EQ(text.substr(begin, end - begin), table) << "run with DRT_UPDATE_DOCS=1";
    }
    if (update) std::ofstream(page, std::ios::binary) << text;
}

TEST(SceneDocs, DescribesNothingElse) {
    const std::string text = load_page();
    std::size_t tables = 0;
    for (std::size_t at = 0; (at = text.find("<!-- fields of ", at)) != std::string::npos; ++at) ++tables;
    EXPECT_EQ(tables, scene_reference().size());
}

// The blocks of code that are YAML, in order.
std::vector<std::string> examples() {
    const std::string text = load_page(), fence = "```yaml\n";
    std::vector<std::string> out;
    for (std::size_t at = 0; (at = text.find(fence, at)) != std::string::npos;) {
        const std::size_t begin = at + fence.size();
        at = text.find("```", begin);
        out.push_back(text.substr(begin, at - begin));
    }
    return out;
}

TEST(SceneDocs, EveryExampleIsRead) {
    const std::vector<std::string> all = examples();
    ASSERT_GE(all.size(), 2u);
    for (const std::string& example : all) {
        const TemporaryFiles files;
        files.write("materials.yaml", "drt: 1\nmaterials:\n  - {name: red}\n");  // what the examples include
        const bool whole = example.starts_with("drt: 1");
        const std::string around = "drt: 1\ninclude: materials.yaml\n";
        const bool has_camera = example.find("cameras:") != std::string::npos;
        const std::string text = whole ? example : around + (has_camera ? "" : "cameras: [{}]\n") + example;
        try {
            const SceneRead read = read_yaml_scene(files.write("example.yaml", text));
            EXPECT_TRUE(!whole || read.notes.empty()) << to_string(read.notes.front());
        } catch (const Error& e) {
            ADD_FAILURE() << e.what() << "\n\n" << text;
        }
    }
}

// The message that the page quotes is the one that is given.
TEST(SceneDocs, TheErrorShownIsReal) {
    const TemporaryFiles files;
    const std::string text =
        "drt: 1\n"
        "cameras: [{}]\n"
        "materials:\n"
        "  - name: red\n"
        "    shininess: 1,5\n"
        "bodies:\n"
        "  - {type: sphere, materail: red, radius: 2}\n"
        "  - {type: sphere, material: rde, radius: -2}\n";
    try {
        read_yaml_scene(files.write("balls.yaml", text));
        FAIL();
    } catch (const Error& e) {
        EXPECT_NE(load_page().find(files.without_folder(e.what())), std::string::npos)
            << files.without_folder(e.what());
    }
}

}  // namespace
}  // namespace drt
