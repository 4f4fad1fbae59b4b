#include "drt/base/vec.h"

#include <gtest/gtest.h>

#include <random>

#include "drt/base/color.h"
#include "drt/base/constants.h"
#include "drt/base/frame.h"
#include "drt/base/quat.h"

namespace drt {
namespace {

using LaneF = Lane<float, native_width<float>>;
using LaneI = Rebind<LaneF, int>;

template <class A, class B>
concept Multipliable = requires(A a, B b) {
    a* b;
};
static_assert(!Multipliable<Vec3f, Color>, "a colour is not a vector");

TEST(Vec, CrossIsRightHanded) { EXPECT_EQ(cross(Vec3d{1, 0, 0}, Vec3d{0, 1, 0}), (Vec3d{0, 0, 1})); }

TEST(Quat, TurnsRightHandedAndBack) {
    const Quatd q = quat_from_axis_angle({0, 0, 1}, pi<double> / 2);
    const Vec3d v = rotate(q, Vec3d{1, 0, 0});
    EXPECT_NEAR(v.x, 0, 1e-15);
    EXPECT_NEAR(v.y, 1, 1e-15);
    EXPECT_NEAR(rotate_back(q, v).x, 1, 1e-15);
}

TEST(Frame, IsOrthonormalForEveryDirection) {
    std::mt19937 rng(1);
    std::normal_distribution<double> gauss;
    for (int i = 0; i < 10000; ++i) {
        Vec3d z{gauss(rng), gauss(rng), gauss(rng)};
        if (i < 2) z = {0, 0, i == 0 ? 1.0 : -1.0};
        const Frame<double> f = frame_around(normalize(z));
        EXPECT_NEAR(length(f.x), 1, 1e-14);
        EXPECT_NEAR(length(f.y), 1, 1e-14);
        EXPECT_NEAR(dot(f.x, f.y), 0, 1e-14);
        EXPECT_NEAR(dot(cross(f.x, f.y), f.z), 1, 1e-14);
    }
}

TEST(Simd, LanesAgreeWithScalars) {
    const LaneF a = iota<LaneF>(), b(3.5f);
    const LaneF m = select(a < b, a, b);
    for (int i = 0; i < width_of<LaneF>; ++i) EXPECT_EQ(lane(m, i), std::min(float(i), 3.5f));
    EXPECT_EQ(count(first_lanes<LaneF>(3)), 3);
    EXPECT_EQ(reduce_max(a), float(width_of<LaneF> - 1));
    const LaneI truncated = num_cast<LaneI>(b);
    EXPECT_EQ(lane(truncated, 0), 3);
}

TEST(Simd, GatherReadsEachLanesElement) {
    std::vector<float> table(100);
    for (int i = 0; i < 100; ++i) table[size_t(i)] = float(i) * 0.5f;
    const LaneI index = iota<LaneI>() * 3 + 1;
    const LaneF v = gather<LaneF>(table.data(), index);
    for (int i = 0; i < width_of<LaneF>; ++i) EXPECT_EQ(lane(v, i), float(3 * i + 1) * 0.5f);
}

TEST(Simd, MasksCrossTypes) {
    const auto m = iota<LaneF>() < LaneF(2);
    const LaneI v = select(mask_cast<LaneI>(m), LaneI(7), LaneI(9));
    EXPECT_EQ(lane(v, 1), 7);
    EXPECT_EQ(lane(v, 2), 9);
}

}  // namespace
}  // namespace drt
