// Every shipped scene still looks as its reference picture does.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "regression/regression.h"

namespace drt {

void PrintTo(const Shot& shot, std::ostream* out) { *out << shot.name; }

namespace {

namespace fs = std::filesystem;

class Regression : public ::testing::TestWithParam<Shot> {};

TEST_P(Regression, LooksAsTheReference) {
    const Shot& shot = GetParam();
    const SceneDesc scene = read_shot(shot);
    const CompareResult result = compare_with_reference(shot, scene, 1, test_seed);
    const ReferencePicture reference = read_reference(reference_path(shot));
    EXPECT_TRUE(result.same) << result.report
                             << (hash_scene(scene, repository()) == reference.scene_hash
                                     ? "The scene says the same as when drt "
                                     : "The scene, or how it is read, has changed since drt ")
                             << reference.version << " made the reference. If the new picture is right, renew it: "
                             << "docs/regression.md\n";
}

std::string test_name(const ::testing::TestParamInfo<Shot>& shot) {
    std::string name = shot.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Regression, ::testing::ValuesIn(shots()), test_name);

/// What stands in scenes/ for itself: `*-common.yaml` are included by others.
std::set<std::string> shipped_scenes() {
    std::set<std::string> files;
    for (const std::string folder : {"scenes/", "scenes/legacy/"}) {
        for (const auto& entry : fs::directory_iterator(repository() + "/" + folder)) {
            const fs::path name = entry.path().filename();
            const bool scene = name.extension() == ".yaml" || name.extension() == ".txt";
            if (scene && !name.string().ends_with("-common.yaml")) files.insert(folder + name.string());
        }
    }
    return files;
}

TEST(RegressionSet, HasEveryShippedScene) {
    std::set<std::string> files;
    for (const Shot& shot : shots())
        if (shot.file.starts_with("scenes/")) files.insert(shot.file);
    EXPECT_EQ(files, shipped_scenes());
}

TEST(RegressionSet, HasNoReferenceWithoutScene) {
    std::set<std::string> expected, found;
    for (const Shot& shot : shots()) expected.insert(reference_path(shot));
    for (const auto& entry : fs::directory_iterator(fs::path(reference_path(shots()[0])).parent_path()))
        found.insert(entry.path().string());
    EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace drt
