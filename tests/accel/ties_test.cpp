// Bodies in the same place: which one is hit must not depend on the order in which the BVH is walked.

#include <gtest/gtest.h>

#include <algorithm>

#include "brute_force.h"

namespace drt {
namespace {

using test::OneHit;
using test::OneRay;
using test::Random;

const BoxShape<double> unit_box{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

BodyInput ranked(const AnyShape& shape, const Vec3d& center, int rank) { return {shape, center, {}, {rank, false}}; }

TEST(Ties, OfCoincidentBodiesTheLowestRankIsHit) {
    Random r(1);
    std::vector<BodyInput> inputs;
    for (int i = 0; i < 60; ++i)
        inputs.push_back(ranked(i % 2 ? AnyShape(SphereShape<double>{1}) : AnyShape(unit_box), {20.0 * (i % 2), 0, 0},
                                (i + 17) % 60));  // the lowest: 43, a sphere, and 44, a box
    const BuiltTable<float> built = build_body_table<float>(inputs);
    const Accel<float> accel(built.table);
    for (int k = 0; k < 3000; ++k) {
        const int which = r.below(2);
        const Vec3d center{20.0 * which, 0, 0};
        const Vec3d o = center + r.direction() * 8.0;
        const OneRay<float> ray{Vec3f(o), Vec3f(normalize(center + r.in_box(0.3) - o))};
        EXPECT_EQ(test::trace(accel, ray).body, which == 1 ? 43 / 2 : 30 + 44 / 2);  // ids by kind: spheres first
    }
}

TEST(Ties, AHundredThousandCoincidentSpheres) {
    std::vector<BodyInput> inputs;
    for (int i = 0; i < 100000; ++i) inputs.push_back(ranked(SphereShape<double>{1}, {0, 0, -5}, (i + 77) % 100000));
    const BuiltTable<float> built = build_body_table<float>(inputs);
    const Accel<float> accel(built.table);
    Random r(2);
    for (int k = 0; k < 20; ++k) {
        const OneRay<float> ray{{}, Vec3f(normalize(Vec3d{r.uniform(-0.1, 0.1), r.uniform(-0.1, 0.1), -1}))};
        const OneHit hit = test::trace(accel, ray);
        EXPECT_EQ(hit.body, 100000 - 77);
        EXPECT_NEAR(hit.t, 4, 0.2);
    }
}

// Two boxes, the second one's face in the first one's: along the shared plane both faces are hit at the same distance
// but for rounding. One owner over the whole face, or there would be speckle.
template <class Real>
void expect_one_owner(const Vec3d& position, const Quatd& turn) {
    const test::Axes a = test::axes_of(turn);
    const BoxShape<double> box{a.x, a.y, a.z, {1, 1, 1}}, flat_box{a.x, a.y, a.z, {0.3, 0.7, 0.7}};
    // both faces at +x of the first's centre: 1 = 0.7 + 0.3
    const BuiltTable<Real> built =
        build_body_table<Real>({ranked(box, position, 1), ranked(flat_box, position + a.x * 0.7, 0)});
    const Accel<Real> accel(built.table);
    Random r(3);
    int others = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3d target = position + a.x + a.y * r.uniform(-0.6, 0.6) + a.z * r.uniform(-0.6, 0.6);
        Vec3d away = r.direction();
        if (dot(away, a.x) < 0) away = -away;
        if (dot(away, a.x) < 0.2) continue;
        const Vec3<Real> o(target + away * 6.0);
        const OneRay<Real> ray{o, normalize(Vec3<Real>(target) - o)};
        others += test::trace(accel, ray).body != 1;
    }
    EXPECT_EQ(others, 0);
}

TEST(Ties, CoincidentFacesHaveOneOwner) {
    const Quatd turn = quat_from_axis_angle(normalize(Vec3d{1, 2, -1}), 0.6);
    for (const Vec3d& position : {Vec3d{0, 0, 0}, Vec3d{3, 4, -20}, Vec3d{100, 30, -200}}) {
        expect_one_owner<double>(position, Quatd{});
        expect_one_owner<double>(position, turn);
        expect_one_owner<float>(position, Quatd{});
        expect_one_owner<float>(position, turn);
    }
}

// A disc that lies on the ground: rays that leave the one upwards are not stopped by the other.
TEST(Ties, ACoincidentSurfaceDoesNotShadowTheStart) {
    const BuiltTable<float> built =
        build_body_table<float>({{test::flat_shape({}, {5, 0, 0}, {0, 0, -5}, Outline::disc), {3, -2, -7}, {}},
                                 {PlaneShape<double>{{0, 1, 0}}, {0, -2, 0}, {}}});
    const Accel<float> accel(built.table);
    Random r(4);
    int blocked = 0, rays = 0;
    for (int k = 0; k < 5000; ++k) {
        const Vec3d o{r.uniform(-20, 20), r.uniform(-1, 5), r.uniform(-20, 20)};
        const Vec3d target{r.uniform(0, 6), -2, r.uniform(-10, -4)};
        const OneRay<float> down{Vec3f(o), normalize(Vec3f(target) - Vec3f(o))};
        const OneHit hit = test::trace(accel, down);
        Vec3d up = r.direction();
        up.y = std::abs(up.y);
        if (up.y < 0.3 || down.d.y > -0.1f) continue;
        const Vec3f p = down.o + down.d * float(hit.t);
        const test::OneDeparture<float> from(down.d, float(hit.t), start::none, {});
        for (const int body : {0, 1}) {
            ++rays;
            const OneRay<float> shadow{p, Vec3f(up), 1e30f, 0, start::pack(body, 0, 1)};
            blocked += test::blocked(accel, shadow, -1, &from);
        }
    }
    EXPECT_GT(rays, 4000);
    EXPECT_EQ(blocked, 0);
}

}  // namespace
}  // namespace drt
