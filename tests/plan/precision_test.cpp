// When float is enough.

#include <gtest/gtest.h>

#include "plan_parts.h"

namespace drt {
namespace {

bool uses_double(const SceneDesc& s, PlanOptions options = {}) {
    const RenderPlan plan = compile(s, options);
    EXPECT_EQ(plan.features.double_precision, std::holds_alternative<std::unique_ptr<World<double>>>(plan.world));
    return plan.features.double_precision;
}

TEST(Precision, OrdinaryScenesAreInFloat) {
    EXPECT_FALSE(uses_double(test::scene_with(sphere({0, 0, -5}, 1))));
    EXPECT_FALSE(uses_double(test::scene_with(Plane{{0, -1.5, 0}})));
}

TEST(Precision, ASmallBodyInALargeSceneNeedsDouble) {
    SceneDesc s = test::scene_with(sphere({0, 0, -5}, 0.01));
    EXPECT_FALSE(uses_double(s));
    s.bodies.push_back(body("far", sphere({0, 0, -500}, 1), "grey"));
    EXPECT_TRUE(uses_double(s));
}

TEST(Precision, WhereTheSceneLiesDoesNotMatter) {
    SceneDesc s = test::scene_with(sphere({1e6, 2e6, -5}, 1));
    s.cameras[0].positions = {{1e6, 2e6, 0}};
    s.cameras[0].targets = {{1e6, 2e6, -1}};
    EXPECT_FALSE(uses_double(s));
    EXPECT_EQ(std::get<std::unique_ptr<World<float>>>(compile(s, {}).world)->origin, (Vec3d{1e6, 2e6, 0}));
}

TEST(Precision, AHugeGroundSphereNeedsDouble) {
    EXPECT_TRUE(uses_double(test::scene_with(sphere({0, -1e6 - 1.5, 0}, 1e6))));
    EXPECT_FALSE(uses_double(test::scene_with(sphere({0, -1e3 - 1.5, 0}, 1e3))));
}

TEST(Precision, ATelescopeNeedsDouble) {
    SceneDesc s = test::scene_with(sphere({0, 0, -5}, 1));
    s.cameras[0].fov_degrees_start = 0.01;
    EXPECT_TRUE(uses_double(s));
}

// A moving body is where its keys are, not where it was described.
TEST(Precision, AMovingBodyCountsWhereItIs) {
    SceneDesc s = test::scene_with(sphere({0, 0, 0}, 0.01));
    s.bodies[0].motion = Motion{Motion::Interpolation::linear, {key(0, {0, 0, -500}), key(1, {0, 1, -500})}};
    EXPECT_TRUE(uses_double(s));
    s.bodies[0].shape = sphere({1e9, 0, 0}, 1);
    EXPECT_FALSE(uses_double(s));
}

TEST(Precision, IsWhatIsAskedFor) {
    PlanOptions options;
    options.precision = PlanOptions::Precision::double_;
    EXPECT_TRUE(uses_double(test::scene_with(sphere({0, 0, -5}, 1)), options));
    options.precision = PlanOptions::Precision::single;
    EXPECT_FALSE(uses_double(test::scene_with(sphere({0, -1e6 - 1.5, 0}, 1e6)), options));
}

}  // namespace
}  // namespace drt
