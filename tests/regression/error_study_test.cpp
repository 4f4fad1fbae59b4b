// Fewer seeds and samples of what measure_error_estimates.cpp prints.

#include "regression/error_study.h"

#include <gtest/gtest.h>

namespace drt {
namespace {

TEST(ErrorStudy, OneInAHundredPicturesMisleadsAtMost) {
    StudyOptions options;
    options.seeds = 30;
    options.most_spp = 128;
    int pictures = 0, misleading = 0;
    const auto count = [&](const StudyScene& scene) {
        int here = 0;
        for (const ErrorTrial& t : study_errors(scene, options)) ++pictures, here += t.misleads();
        misleading += here;
        if (here > 0) std::printf("%s: %d misleading\n", scene.name.c_str(), here);
    };
    for (const StudyScene& scene : fireflies_to_study()) count(scene);
    for (const StudyScene& scene : shipped_scenes_to_study()) count(scene);
    EXPECT_LE(misleading, pictures / 100);
}

}  // namespace
}  // namespace drt
