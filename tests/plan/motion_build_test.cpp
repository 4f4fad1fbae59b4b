// Keyframes to pieces, against keyframes evaluated directly at each time.

#include "drt/plan/motion_build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drt/base/constants.h"
#include "support/scene_parts.h"

namespace drt {
namespace {

// ---- the slow way
// ----------------------------------------------------------------------------------------------------

// Non-uniform Catmull-Rom: the slope between the neighbours, one-sided at the ends.
Vec3d slope(const std::vector<MotionKey>& k, size_t i) {
    const size_t before = i > 0 ? i - 1 : i, after = i + 1 < k.size() ? i + 1 : i;
    return (k[after].position - k[before].position) / (k[after].time - k[before].time);
}

Vec3d position_at(const Motion& m, double time) {
    const auto& k = m.keys;
    if (time <= k.front().time) return k.front().position;
    if (time >= k.back().time) return k.back().position;
    size_t i = 0;
    while (k[i + 1].time < time) ++i;
    const double dt = k[i + 1].time - k[i].time, h = (time - k[i].time) / dt;
    if (m.interpolation == Motion::Interpolation::linear) return k[i].position * (1 - h) + k[i + 1].position * h;
    // the Hermite basis
    const double h2 = h * h, h3 = h2 * h;
    return k[i].position * (2 * h3 - 3 * h2 + 1) + slope(k, i) * (dt * (h3 - 2 * h2 + h)) +
           k[i + 1].position * (3 * h2 - 2 * h3) + slope(k, i + 1) * (dt * (h3 - h2));
}

Quatd slerp(const Quatd& a, Quatd b, double h) {
    if (dot(a, b) < 0) b = -b;
    const double angle = std::acos(std::min(1.0, dot(a, b)));
    if (angle < 1e-9) return a;
    const double wa = std::sin((1 - h) * angle) / std::sin(angle), wb = std::sin(h * angle) / std::sin(angle);
    return {a.w * wa + b.w * wb, a.x * wa + b.x * wb, a.y * wa + b.y * wb, a.z * wa + b.z * wb};
}

Quatd key_orientation(const Motion& m, size_t i) {
    const MotionKey& k = m.keys[i];
    if (!k.turn) return normalize(k.orientation.value_or(Quatd{}));
    const Quatd turn = quat_from_axis_angle(normalize(k.turn->axis), radians(k.turn->degrees));
    return i == 0 ? turn : turn * key_orientation(m, i - 1);
}

Quatd orientation_at(const Motion& m, double time) {
    const auto& k = m.keys;
    if (time <= k.front().time) return key_orientation(m, 0);
    if (time >= k.back().time) return key_orientation(m, k.size() - 1);
    size_t i = 0;
    while (k[i + 1].time < time) ++i;
    const double h = (time - k[i].time) / (k[i + 1].time - k[i].time);
    const Quatd from = key_orientation(m, i);
    if (const auto& turn = k[i + 1].turn)
        return quat_from_axis_angle(normalize(turn->axis), radians(turn->degrees) * h) * from;
    return slerp(from, key_orientation(m, i + 1), h);
}

// ---- comparison
// ------------------------------------------------------------------------------------------------------

// The rotation, whatever the quaternion's sign.
double difference(const Quatd& a, const Quatd& b) {
    double worst = 0;
    for (const Vec3d& v : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
        worst = std::max(worst, length(rotate(a, v) - rotate(b, v)));
    return worst;
}

void expect_path(const Motion& m, double time0, double time1) {
    const auto path = build_path(m, time0, time1);
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path[0].begin, 0);
    for (size_t i = 1; i < path.size(); ++i) EXPECT_GT(path[i].begin, path[i - 1].begin);
    for (int i = 0; i <= 97; ++i) {
        const double u = i / 97.0, time = time0 + (time1 - time0) * u;
        const Pose<double> pose = pose_at<double>(path, u);
        EXPECT_LE(length(pose.center - position_at(m, time)), 1e-12) << "time " << time;
        EXPECT_LE(difference(pose.orientation, orientation_at(m, time)), 1e-7) << "time " << time;
    }
}

Motion motion(Motion::Interpolation interpolation, std::vector<MotionKey> keys) { return {interpolation, keys}; }

const auto linear = Motion::Interpolation::linear, cubic = Motion::Interpolation::cubic;

std::vector<MotionKey> some_keys() {
    const Quatd q1 = quat_from_axis_angle({0, 1, 0}, 1), q2 = quat_from_axis_angle(normalize(Vec3d{1, 1, 0}), 2.5);
    return {key(1, {0, 0, 0}, Quatd{2, 0, 0, 0}), key(1.5, {1, 2, 0}, q1), key(3, {4, 0, 1}, q2),
            turning_key(3.25, {5, 5, 5}, {0, 3, 0}, 350), key(6, {0, 0, 7}, -q1)};
}

TEST(BuildPath, IsTheKeyframesOverAnyExposure) {
    const std::vector<std::pair<double, double>> exposures{{1, 1.5}, {1.1, 1.2}, {0, 10},    {-3, 0.5}, {0.5, 1.25},
                                                           {2, 3.1}, {2, 6},     {1.6, 2.9}, {7, 9},    {5.9, 12},
                                                           {1.2, 0}, {10, 0},    {6, 3.25},  {3.2, 1.4}};
    for (const auto interpolation : {linear, cubic})
        for (const auto& [open, close] : exposures) {
            SCOPED_TRACE(testing::Message() << open << " to " << close);
            expect_path(motion(interpolation, some_keys()), open, close);
        }
}

TEST(BuildPath, OfRandomKeysIsTheKeyframes) {
    std::mt19937 engine(1);
    const auto u = [&] { return double(engine()) * 0x1p-32; };
    for (int k = 0; k < 60; ++k) {
        std::vector<MotionKey> keys;
        double time = u();
        for (int i = 0; i < 1 + k % 6; ++i, time += 0.01 + u()) {
            const Vec3d p{u(), u(), u()}, axis{u() + 0.1, u(), -u()};
            keys.push_back(i % 2 ? turning_key(time, p, axis, 1500 * u() - 750)
                                 : key(time, p, quat_from_axis_angle(normalize(axis), 6 * u())));
        }
        expect_path(motion(k % 2 ? cubic : linear, keys), 4 * u() - 1, 4 * u() - 1);
    }
}

TEST(BuildPath, ManyTurnsAreTurned) {
    for (const double degrees : {350.0, 720.0, -720.0, 3600.0}) {
        const Motion m = motion(linear, {key(0, {}), turning_key(1, {}, {0, 0, 1}, degrees)});
        const auto path = build_path(m, 0.25, 0.75);
        ASSERT_EQ(path.size(), 1u);
        EXPECT_NEAR(path[0].angle, radians(degrees) / 2, 1e-12);
        expect_path(m, 0.25, 0.75);
    }
}

TEST(BuildPath, WhereNothingMovesIsOneConstantPiece) {
    const Motion m = motion(cubic, some_keys());
    for (const auto& [open, close] : {std::pair{-2.0, 0.5}, {6.0, 8.0}, {2.2, 2.2}, {1.0, 1.0}}) {
        const auto path = build_path(m, open, close);
        EXPECT_EQ(path.size(), 1u);
        EXPECT_TRUE(is_constant(path));
        EXPECT_LE(length(path[0].c0 - position_at(m, open)), 1e-12);
        EXPECT_LE(difference(path[0].q0, orientation_at(m, open)), 1e-7);
    }
    EXPECT_TRUE(is_constant(build_path(motion(linear, {key(3, {1, 2, 3})}), 0, 9)));
    const auto rest = key(1, {1, 2, 3});
    EXPECT_TRUE(is_constant(build_path(motion(cubic, {rest, key(2, {1, 2, 3}), key(3, {1, 2, 3})}), 0, 9)));
    EXPECT_FALSE(is_constant(build_path(m, 0, 1.0001)));
    EXPECT_FALSE(is_constant(build_path(motion(linear, {key(0, {}), turning_key(1, {}, {0, 1, 0}, 360)}), 0, 1)));
}

TEST(BuildPath, PiecesEndAtTheKeys) {
    const auto path = build_path(motion(linear, some_keys()), 0.5, 4.5);
    ASSERT_EQ(path.size(), 5u);  // before, three spans, the last one cut
    const double begins[] = {0, 0.125, 0.25, 0.625, 0.6875};
    for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(path[i].begin, begins[i], 1e-15);
}

}  // namespace
}  // namespace drt
