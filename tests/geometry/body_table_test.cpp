#include "drt/geometry/body_table.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_paths.h"

namespace drt {
namespace {

using test::Random;

std::vector<BodyInput> mixture(int n) {
    Random r(1);
    std::vector<BodyInput> out;
    for (int i = 0; i < n; ++i) {
        BodyInput in{test::random_shape(r, r.below(test::shape_variety)), r.in_box(10), {}};
        if (r.below(2)) in.path = test::random_path(r, 1 + r.below(3), r.below(2) == 1);
        out.push_back(in);
    }
    return out;
}

ShapeKind kind_of(const BodyInput& in) { return ShapeKind(in.shape.index()); }

TEST(BodyTable, EveryBodyIsThereOnce) {
    const auto inputs = mixture(300);
    const BuiltTable<double> built = build_body_table<double>(inputs);
    std::vector<int> order = built.order;
    std::sort(order.begin(), order.end());
    for (int i = 0; i < 300; ++i) EXPECT_EQ(order[size_t(i)], i);
    EXPECT_EQ(built.table.body_count(), 300);
}

TEST(BodyTable, GroupsAreOfOneKindAndCoverAllBodies) {
    const auto inputs = mixture(300);
    const BuiltTable<double> built = build_body_table<double>(inputs);
    int next = 0;
    const auto check = [&](const BodyGroup& g) {
        EXPECT_EQ(g.first, next);
        EXPECT_GT(g.count, 0);
        next += g.count;
        for (int id = g.first; id < g.first + g.count; ++id) {
            const BodyInput& in = inputs[size_t(built.order[size_t(id)])];
            EXPECT_EQ(kind_of(in), g.kind);
            EXPECT_EQ(built.table.path(id).size(), in.path.size());
            EXPECT_TRUE(g.kind == ShapeKind::plane || g.moving == !in.path.empty());
        }
    };
    for (const BodyGroup& g : built.table.groups) {
        EXPECT_NE(g.kind, ShapeKind::plane);
        EXPECT_EQ(g.moving, g.time_steps > 1);
        check(g);
    }
    EXPECT_EQ(built.table.plane_group.kind, ShapeKind::plane);
    check(built.table.plane_group);
    EXPECT_EQ(next, 300);
    EXPECT_EQ(int(built.table.planes.size()), built.table.plane_group.count);
}

TEST(BodyTable, ShapesAndPathsAreThoseOfTheirBodies) {
    const auto inputs = mixture(300);
    const BuiltTable<float> built = build_body_table<float>(inputs);
    for (const BodyGroup& g : built.table.groups)
        for (int id = g.first; id < g.first + g.count; ++id) {
            const BodyInput& in = inputs[size_t(built.order[size_t(id)])];
            const Vec3d center = in.path.empty() ? in.center : in.path[0].c0;
            EXPECT_EQ(built.table.centers[size_t(id)], Vec3f(center));
            for (size_t i = 0; i < in.path.size(); ++i) EXPECT_EQ(built.table.path(id)[i].c3, Vec3f(in.path[i].c3));
            const size_t shape = size_t(g.first_shape + id - g.first);
            if (g.kind == ShapeKind::sphere) {
                EXPECT_EQ(built.table.spheres[shape].radius, float(std::get<SphereShape<double>>(in.shape).radius));
            }
            if (g.kind == ShapeKind::box) {
                EXPECT_EQ(built.table.boxes[shape].half, Vec3f(std::get<BoxShape<double>>(in.shape).half));
            }
        }
}

TEST(BodyTable, WithoutMotionThereAreNoPaths) {
    const BuiltTable<double> built = build_body_table<double>({{SphereShape<double>{1}, {1, 2, 3}, {}}});
    EXPECT_TRUE(built.table.motions.empty());
    EXPECT_TRUE(built.table.pieces.empty());
    EXPECT_TRUE(built.table.path(0).empty());
    EXPECT_EQ(build_body_table<double>({}).table.body_count(), 0);
}

}  // namespace
}  // namespace drt
