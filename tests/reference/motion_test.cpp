#include "reference/motion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace drt::reference {
namespace {

constexpr double pi = std::numbers::pi;

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LT(length(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z; }

Motion path(Motion::Interpolation interpolation, const std::vector<double>& times) {
    Motion motion;
    motion.interpolation = interpolation;
    for (const double t : times) motion.keys.push_back({t, {t * t, 1 - t, 0}, {}, {}});
    return motion;
}

TEST(ReferenceMotion, LinearAndConstantOutside) {
    const Motion motion = path(Motion::Interpolation::linear, {1, 2, 4});
    expect_near(pose_at(motion, 0).position, {1, 0, 0});
    expect_near(pose_at(motion, 3).position, {10, -2, 0});
    expect_near(pose_at(motion, 9).position, {16, -3, 0});
}

// Parabolas at evenly spaced keys have the very tangents of finite differences, except at the ends.
TEST(ReferenceMotion, CubicFollowsAParabolaBetweenInnerKeys) {
    const Motion motion = path(Motion::Interpolation::cubic, {0, 1, 2, 3});
    expect_near(pose_at(motion, 1.25).position, {1.5625, -0.25, 0});
    expect_near(pose_at(motion, 2).position, {4, -1, 0});
    // First interval: p(0) = 0, p(1) = 1, slopes 1 and 2, at 1/2: 1/2 + (1 - 2) / 8.
    expect_near(pose_at(motion, 0.5).position, {0.375, 0.5, 0});
}

// At uneven keys the slope between the neighbours counts: (9 - 0) / (3 - 0) at t = 1.
TEST(ReferenceMotion, CubicAtUnevenKeys) {
    const Motion motion = path(Motion::Interpolation::cubic, {0, 1, 3});
    expect_near(pose_at(motion, 0.5).position, {0.5 + (1.0 - 3.0) / 8, 0.5, 0});
}

TEST(ReferenceMotion, SlerpGoesTheShortWayAndTurnsTheirOwn) {
    const Vec3d x{1, 0, 0}, z{0, 0, 1};
    Motion motion;
    motion.keys = {{0, {}, {}, {}}, {1, {}, -quat_from_axis_angle(z, 3 * pi / 2), {}}};
    expect_near(rotate(pose_at(motion, 0.5).orientation, x), {std::sqrt(0.5), -std::sqrt(0.5), 0});
    motion.keys[1].turn = Turn{{0, 0, 5}, 350};
    const double half = 175 * pi / 180;
    expect_near(rotate(pose_at(motion, 0.5).orientation, x), {std::cos(half), std::sin(half), 0});
    motion.keys.push_back({2, {}, {}, Turn{{1, 0, 0}, 180}});  // about a world axis, after the turn before
    const double end = 350 * pi / 180;
    expect_near(rotate(pose_at(motion, 1.5).orientation, x), {std::cos(end), 0, std::sin(end)});
    expect_near(rotate(pose_at(motion, 2).orientation, x), {std::cos(end), -std::sin(end), 0});
    motion.keys.push_back({3, {}, quat_from_axis_angle(z, pi / 2), {}});  // absolute again
    expect_near(rotate(pose_at(motion, 5).orientation, x), {0, 1, 0});
}

TEST(ReferenceMotion, Centers) {
    expect_near(center_of(Triangle{{0, 0, 0}, {3, 0, 0}, {0, 3, 0}}), {1, 1, 0});
    expect_near(center_of(Rectangle{{0, 0, 0}, {2, 0, 0}, {5, 2, 0}}), {1, 1, 0});
    expect_near(center_of(Cylinder{{0, 0, 0}, {0, 4, 0}, 1, true}), {0, 2, 0});
}

}  // namespace
}  // namespace drt::reference
