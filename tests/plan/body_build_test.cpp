#include "drt/plan/body_build.h"

#include <gtest/gtest.h>

#include "support/scene_parts.h"

namespace drt {
namespace {

template <class S>
S get(const BuiltBody& b) {
    return std::get<S>(b.shape);
}

void expect_near(const Vec3d& a, const Vec3d& b) { EXPECT_LE(length(a - b), 1e-14); }

TEST(BuildBody, FlatCoordinatesRunAlongTheEdges) {
    const Vec3d v0{1, 2, 3}, e0{2, 0, 1}, e1{1, 3, 0};
    for (const Shape& shape : {Shape(Parallelogram{v0, e0, e1}), Shape(Triangle{v0, v0 + e0, v0 + e1})}) {
        const BuiltBody b = build_body(shape);
        const auto s = get<FlatShape<double>>(b);
        const auto at = [&](double a, double c) {
            const Vec3d q = v0 + e0 * a + e1 * c - b.center - s.origin;
            return Vec2d{dot(q, s.da), dot(q, s.db)};
        };
        for (const Vec2d& p : {Vec2d{0, 0}, Vec2d{1, 0}, Vec2d{0, 1}, Vec2d{0.3, 0.6}}) {
            EXPECT_NEAR(at(p.x, p.y).x, p.x, 1e-14);
            EXPECT_NEAR(at(p.x, p.y).y, p.y, 1e-14);
        }
        expect_near(s.normal, normalize(cross(e0, e1)));
    }
}

TEST(BuildBody, CentresAreThoseOfTheDescription) {
    const Vec3d v0{1, 2, 3}, v1{4, 2, 3}, v2{1, 5, 3};
    expect_near(build_body(Triangle{v0, v1, v2}).center, {2, 3, 3});
    expect_near(build_body(Parallelogram{v0, {2, 0, 0}, {1, 3, 0}}).center, {2.5, 3.5, 3});
    expect_near(build_body(Cylinder{{0, 0, 0}, {0, 4, 2}, 1}).center, {0, 2, 1});
    expect_near(build_body(Plane{{1, 1, 1}, {0, 2, 0}}).center, {1, 1, 1});
    expect_near(build_body(Disc{{5, 6, 7}, {0, 0, 3}, 2}).center, {5, 6, 7});
}

// vertex2 lies anywhere on the opposite side's line: only its perpendicular part counts.
TEST(BuildBody, ARectangleIsSpannedByThreeVertices) {
    for (const double along : {-3.0, 0.0, 0.7, 11.0}) {
        const BuiltBody b = build_body(Rectangle{{1, 0, 0}, {3, 0, 0}, {1 + along, 0, -5}});
        expect_near(b.center, {2, 0, -2.5});
        const auto s = get<FlatShape<double>>(b);
        EXPECT_EQ(s.outline, Outline::parallelogram);
        expect_near(s.da, {0.5, 0, 0});
        expect_near(s.db, {0, 0, -0.2});
        expect_near(b.center + s.origin, {1, 0, 0});
    }
}

TEST(BuildBody, DiscsBoxesCylindersHaveUnitAxesAndTheirSizes) {
    const auto disc = get<FlatShape<double>>(build_body(Disc{{}, {0, 0, -7}, 2}));
    EXPECT_EQ(disc.outline, Outline::disc);
    expect_near(disc.normal, {0, 0, -1});
    EXPECT_NEAR(length(disc.da), 0.5, 1e-15);
    EXPECT_NEAR(length(disc.db), 0.5, 1e-15);
    EXPECT_NEAR(dot(disc.da, disc.db), 0, 1e-15);
    EXPECT_NEAR(dot(disc.da, disc.normal), 0, 1e-15);

    const BuiltBody box_body = build_body(Box{{}, {1, 2, 3}, Quatd{0, 0, 0, 5}});  // half a turn about z, not unit
    const auto box = get<BoxShape<double>>(box_body);
    expect_near(box.half, {0.5, 1, 1.5});
    expect_near(box.ax, {-1, 0, 0});
    expect_near(box.az, {0, 0, 1});

    const BuiltBody cylinder_body = build_body(Cylinder{{1, 1, 1}, {1, 1, 9}, 2, false});
    const auto cylinder = get<CylinderShape<double>>(cylinder_body);
    expect_near(cylinder.az, {0, 0, 1});
    EXPECT_EQ(cylinder.half_height, 4);
    EXPECT_EQ(cylinder.radius, 2);
    EXPECT_FALSE(cylinder.capped);
    expect_near(cross(cylinder.ax, cylinder.ay), cylinder.az);
}

TEST(BuildBody, TurningTurnsEveryAxisAndKeepsTheShape) {
    const Quatd q = quat_from_axis_angle(normalize(Vec3d{1, -2, 0.5}), 1.1);
    const auto before = build_body(Box{{1, 2, 3}, {1, 2, 3}, {}});
    const auto box = get<BoxShape<double>>(before);
    const BuiltBody after = turned(before, q);
    expect_near(get<BoxShape<double>>(after).ay, rotate(q, box.ay));
    expect_near(get<BoxShape<double>>(after).half, box.half);
    expect_near(after.center, before.center);
    expect_near(after.mapping->ax, rotate(q, before.mapping->ax));
    expect_near(after.mapping->origin, before.mapping->origin);  // half extents do not turn

    const auto flat = build_body(Parallelogram{{0, 0, 0}, {2, 0, 0}, {1, 3, 0}});
    const BuiltBody turned_flat = turned(flat, q);
    const auto a = get<FlatShape<double>>(flat), b = get<FlatShape<double>>(turned_flat);
    expect_near(b.origin, rotate(q, a.origin));
    expect_near(b.da, rotate(q, a.da));
    expect_near(b.normal, rotate(q, a.normal));
    expect_near(turned_flat.mapping->origin, rotate(q, flat.mapping->origin));

    expect_near(get<PlaneShape<double>>(turned(build_body(Plane{{}, {0, 1, 0}}), q)).normal, rotate(q, Vec3d{0, 1, 0}));
}

TEST(BuildBody, VisibleLightsAreBodies) {
    const BuiltBody r = build_light_body(RectLight{{1, 2, 3}, {2, 0, 0}, {0, 0, 4}, false});
    expect_near(r.center, {2, 2, 5});
    expect_near(get<FlatShape<double>>(r).normal, {0, -1, 0});  // the side that shines
    const BuiltBody s = build_light_body(SphereLight{{1, 2, 3}, 0.5});
    expect_near(s.center, {1, 2, 3});
    EXPECT_EQ(get<SphereShape<double>>(s).radius, 0.5);
}

}  // namespace
}  // namespace drt
