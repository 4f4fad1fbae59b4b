// The example of the 2008 program's manual: a ball that starts 0.2 deep in its table and is struck.

#include <gtest/gtest.h>

#include "drt/bake/bake.h"
#include "drt/formats/formats.h"
#include "reference/motion.h"

namespace drt {
namespace {

class ManualBall : public testing::Test {
protected:
    static void SetUpTestSuite() {
        const SceneDesc scene = read_legacy_scene(DRT_TEST_DATA "/manual_example.txt").scene;
        motion_ = new Motion(*bake(scene, 0).scene.bodies.at(0).motion);
    }
    static void TearDownTestSuite() { delete motion_; }

    static reference::Pose at(double time) { return reference::pose_at(*motion_, time); }
    static Vec3d velocity(double time) { return (at(time + 0.01).position - at(time - 0.01).position) / 0.02; }
    static Vec3d spin(double time) {
        const Quatd q = at(time + 0.01).orientation * conjugate(at(time - 0.01).orientation);
        const Vec3d v{q.x, q.y, q.z};
        return v * (2 * std::copysign(std::asin(std::min(1.0, length(v))) / length(v), q.w) / 0.02);
    }

private:
    static const Motion* motion_;
};

const Motion* ManualBall::motion_ = nullptr;

TEST_F(ManualBall, IsNotThrownUp) {
    EXPECT_EQ(at(0).position.x, 60);
    double highest = 0, lowest = 1e9;
    for (int i = 1; i <= 1000; ++i) {
        highest = std::max(highest, at(i / 1000.0).position.y);
        if (i >= 10) lowest = std::min(lowest, at(i / 1000.0).position.y);
    }
    EXPECT_LT(highest, 4.05);
    EXPECT_GT(lowest, 3.95);
}

TEST_F(ManualBall, HasTheSpeedOfTheBlow) {
    EXPECT_NEAR(length(velocity(0.08)), 0, 0.01);
    EXPECT_NEAR(velocity(0.12).x, 18.65 - 0.5 * 9.81 * 0.02, 0.2);  // friction slows it down from 0.1 s on
}

// From sliding to rolling: 5 / 7 of the speed.
TEST_F(ManualBall, Rolls) {
    const double speed = 1e5 * 0.05 / (4 * 3.14159265358979 / 3 * 64) * 5 / 7;
    EXPECT_NEAR(velocity(3).x, speed, 0.02 * speed);
    EXPECT_NEAR(-spin(3).z * 4, velocity(3).x, 0.01 * speed);
    EXPECT_NEAR(at(3).position.y, 4, 0.01);
    EXPECT_NEAR(velocity(3).z, 0, 1e-3);
}

}  // namespace
}  // namespace drt
