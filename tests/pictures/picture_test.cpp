#include "pictures/picture_test.h"

#include <algorithm>
#include <cctype>
#include <ostream>

#include "reference/reference.h"
#include "support/compare.h"
#include "support/render_picture.h"

namespace drt {

void expect_same_as_reference(const PictureCase& picture, const PlanOptions& options, int reference_spp,
                              int render_spp) {
    const SceneDesc& scene = picture.scene;
    const PictureEstimate expected =
        render_reference(picture.reference_scene.value_or(scene), picture.frame, scene.render.width,
                         scene.render.height, reference_spp, /*seed=*/1);
    PlanOptions plan = options;
    plan.frame = picture.frame;
    CompareOptions compare;
    compare.absolute_tolerance = picture.tolerance;
    compare.rare_step = picture.rare / reference_spp;
    const CompareResult result = compare_pictures(estimate_scene(scene, plan, render_spp), expected, compare);
    EXPECT_TRUE(result.same) << picture.name << ", drt and reference: " << result.report;
}

void PrintTo(const PictureCase& picture, std::ostream* out) { *out << picture.name; }

std::string test_name(const ::testing::TestParamInfo<PictureCase>& info) {
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
}

}  // namespace drt
