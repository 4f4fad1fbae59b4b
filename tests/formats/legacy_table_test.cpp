// The table of elements against its documentation, and against itself.
#include "drt/formats/legacy_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "formats/legacy_fixture.h"

namespace drt {
namespace {

std::string documentation() {
    std::ostringstream out;
    out << std::ifstream(DRT_SOURCE_DIR "/docs/legacy-format.md").rdbuf();
    return out.str();
}

TEST(LegacyTable, EveryElementAttributeAndAliasIsDocumented) {
    const std::string text = documentation();
    const auto has = [&text](std::string_view word) { return text.find('`' + std::string(word)) != std::string::npos; };
    for (const LegacyElementType& e : legacy_elements()) {
        EXPECT_TRUE(has(e.name) || text.find("### " + std::string(e.name)) != std::string::npos) << e.name;
        for (const LegacyAttribute& a : e.attributes) {
            EXPECT_TRUE(has(a.name)) << a.name;
            for (const std::string_view alias : a.aliases) EXPECT_TRUE(alias.empty() || has(alias)) << alias;
        }
    }
}

TEST(LegacyTable, NamesAreUniqueWithinAnElement) {
    for (const LegacyElementType& e : legacy_elements()) {
        std::set<std::string_view> names;
        for (const LegacyAttribute& a : e.attributes) {
            EXPECT_TRUE(names.insert(a.name).second) << a.name;
            for (const std::string_view alias : a.aliases)
                EXPECT_TRUE(alias.empty() || names.insert(alias).second) << alias;
        }
    }
}

// Every element with nothing in it is read (the texture's file apart), and every default is told.
TEST(LegacyTable, EveryElementHasSoundDefaults) {
    for (const LegacyElementType& e : legacy_elements()) {
        if (e.kind == LegacyKind::texture) continue;
        const std::string name(e.name);
        const SceneRead r = legacy_test::read(name + " X { }\n" + (name == "camera" ? "" : legacy_test::camera));
        for (const LegacyAttribute& a : e.attributes) {
            const std::string words =
                "default used: " + name + ' ' + std::string(a.name) + " = " + std::string(a.fallback);
            EXPECT_EQ(legacy_test::says(r, words), !a.fallback.empty()) << words;
        }
    }
}

}  // namespace
}  // namespace drt
