#include "drt/base/diagnostic.h"

#include <gtest/gtest.h>

namespace drt {
namespace {

TEST(Diagnostic, PrintsPlaceTextExpectationAndSuggestion) {
    const Diagnostic d{Severity::error, {"a.yaml", 3, 7}, "unknown key", "radiuss", "a key of sphere", "radius"};
    EXPECT_EQ(to_string(d),
              "a.yaml:3:7: error: unknown key \"radiuss\"; expected a key of sphere; did you mean \"radius\"?");
}

TEST(Diagnostic, LeavesOutWhatIsEmpty) {
    EXPECT_EQ(to_string(Diagnostic{Severity::warning, {}, "no lights", {}, {}, {}}), "warning: no lights");
}

TEST(Diagnostic, ErrorHoldsAllLines) {
    const Error e(ErrorKind::scene, Diagnostics{{Severity::error, {"f", 1, 2}, "a", {}, {}, {}},
                                                {Severity::error, {"f", 3, 4}, "b", {}, {}, {}}});
    EXPECT_STREQ(e.what(), "f:1:2: error: a\nf:3:4: error: b");
    EXPECT_EQ(e.diagnostics().size(), 2u);
}

TEST(NearestWord, FindsMisspellingsAndSwapsButNotStrangers) {
    const std::vector<std::string_view> words{"radius", "center", "material"};
    EXPECT_EQ(nearest_word("radiuss", words), "radius");
    EXPECT_EQ(nearest_word("centre", words), "center");
    EXPECT_EQ(nearest_word("amterial", words), "material");
    EXPECT_EQ(nearest_word("colour", words), "");
    EXPECT_EQ(nearest_word(std::string(100000, 'x'), words), "");
}

}  // namespace
}  // namespace drt
