// What the comparison of pictures can and cannot see, on real pictures: the reference renderer against itself, with
// other random numbers and planted faults.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "pictures/scenes.h"
#include "reference/reference.h"
#include "support/compare.h"
#include "support/plant_faults.h"

namespace drt {
namespace {

/// Compares a picture with the same scene after `change`, with other random numbers.
CompareResult compare_changed(const std::string& name, const std::function<void(SceneDesc&)>& change, int spp = 64) {
    const PictureCase picture = find_picture(name, ::testing::TempDir());
    SceneDesc changed = picture.scene;
    change(changed);
    const auto render = [&](const SceneDesc& scene, std::uint64_t seed) {
        return render_reference(scene, picture.frame, scene.render.width, scene.render.height, spp, seed);
    };
    return compare_pictures(render(picture.scene, 1), render(changed, 2));
}

TEST(Sensitivity, NoisePasses) {
    for (const char* name : {"rectangle light", "glossy reflection", "motion blur", "visible lights", "shapes",
                             "blackman-harris filter", "two-sided rectangle", "lights cut by the horizon"}) {
        const CompareResult result = compare_changed(name, [](SceneDesc&) {});
        EXPECT_TRUE(result.same) << name << ": " << result.report;
    }
}

TEST(Sensitivity, ALightTwoPercentOffIsSeen) {
    for (const char* name : {"rectangle light", "uniform sphere light", "legacy radial sphere light", "shapes"}) {
        const CompareResult result = compare_changed(name, [](SceneDesc& scene) { brighten_lights(scene, 1.02f); });
        EXPECT_FALSE(result.same) << name << ": " << result.report;
    }
}

TEST(Sensitivity, ALightTwoPercentLargerIsSeen) {
    const CompareResult result = compare_changed(
        "uniform sphere light", [](SceneDesc& scene) { std::get<SphereLight>(scene.lights[0].shape).radius *= 1.02; });
    EXPECT_FALSE(result.same) << result.report;
}

TEST(Sensitivity, ALobeFivePercentWiderIsSeen) {
    const auto widen = [](SceneDesc& scene) { widen_lobes(scene, 1.05); };
    const CompareResult reflection = compare_changed("glossy reflection", widen, 256);
    EXPECT_FALSE(reflection.same) << reflection.report;
    const CompareResult refraction = compare_changed("glossy refraction", widen, 640);
    EXPECT_FALSE(refraction.same) << refraction.report;
}

TEST(Sensitivity, AFilterShiftedByATenthOfAPixelIsSeen) {
    for (const char* name : {"blackman-harris filter", "gaussian filter", "shapes"}) {
        const CompareResult result = compare_changed(name, [](SceneDesc& scene) { shift_filter(scene, 0.1); });
        EXPECT_FALSE(result.same) << name << ": " << result.report;
    }
}

TEST(Sensitivity, ALensTenPercentLargerIsSeen) {
    const CompareResult result = compare_changed(
        "uniform lens, plane of focus", [](SceneDesc& scene) { scene.cameras[0].lens.aperture_radius *= 1.1; }, 256);
    EXPECT_FALSE(result.same) << result.report;
}

}  // namespace
}  // namespace drt
