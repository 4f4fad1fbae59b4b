// Every shape's arithmetic against exact crossings, in float and double, scalars and lanes.

#include "drt/geometry/intersect.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "exact_shapes.h"
#include "random_shapes.h"

namespace drt {
namespace {

using test::Crossing;
using test::Quad;
using test::Random;

template <class Real>
struct RayOf {
    Vec3<Real> o, d;
};

template <class Real>
test::Ray exact(const RayOf<Real>& r) {
    return {{Quad(r.o.x), Quad(r.o.y), Quad(r.o.z)}, {Quad(r.d.x), Quad(r.d.y), Quad(r.d.z)}};
}

template <class T>
Relation<T> free_start() {
    return {MaskOf<T>(false), MaskOf<T>(false), Rebind<T, int>(0)};
}

template <class Real, class Shape>
ShapeHit<Real> hit_scalar(const Shape& s, const RayOf<Real>& r) {
    return intersect<Real>(s, r.o, r.d, free_start<Real>(), Real(0), std::numeric_limits<Real>::infinity());
}

template <class Shape>
ShapeHit<double> meet(const Shape& s, const RayOf<double>& r) {
    return hit_scalar(s, r);
}

// The ray in one lane of many, among rays that miss.
template <class Real, class Shape>
ShapeHit<Real> hit_lane(const Shape& s, const RayOf<Real>& r, int i) {
    using R = typename Pack<Real>::R;
    Vec3<R> o(Vec3<Real>{0, Real(1e7), 0}), d(Vec3<Real>{0, 1, 0});
    o.x[i] = r.o.x, o.y[i] = r.o.y, o.z[i] = r.o.z;
    d.x[i] = r.d.x, d.y[i] = r.d.y, d.z[i] = r.d.z;
    const ShapeHit<R> h = intersect<R>(s, o, d, free_start<R>(), R(0), R(std::numeric_limits<Real>::infinity()));
    return {lane_bit(h.valid, i), lane(h.t, i), {lane(h.ng.x, i), lane(h.ng.y, i), lane(h.ng.z, i)}, lane(h.part, i)};
}

std::optional<Crossing> first_ahead(const std::vector<Crossing>& all) {
    for (const Crossing& c : all)
        if (c.t > 0) return c;
    return {};
}

// What rounding may do to a surface: all dimensions larger, all smaller, and edges moved along either face.
const Vec3d variations[] = {{1, 1, 1}, {-1, -1, -1}, {1, -1, 1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1}};

struct Outcome {
    int wrong = 0, undecided = 0, hits = 0;
    double worst = 0;  // displacement along the normal, in units of the tolerance
};

/// `tolerance` is a length. Rays for which a surface moved by it would be hit elsewhere decide nothing.
template <class Real, class Shape>
void check(const Shape& s, const RayOf<Real>& ray, const ShapeHit<Real>& hit, double tolerance, Outcome& out) {
    const test::Ray r = exact(ray);
    const auto truth = first_ahead(test::crossings(s, r, Vec3d{}));
    for (const Vec3d& v : variations) {
        const auto other = first_ahead(test::crossings(s, r, v * tolerance));
        if (other.has_value() != truth.has_value() ||
            (truth && (other->part != truth->part || dot(other->normal, truth->normal) < 0.9))) {
            ++out.undecided;
            return;
        }
    }
    const bool right = hit.valid == truth.has_value() &&
                       (!truth || (hit.part == truth->part &&
                                   length(normalize(Vec3d(hit.ng)) - truth->normal) * truth->cosine * 0.1 < 1e-2));
    if (!right) ++out.wrong;
    if (!right || !truth) return;
    ++out.hits;
    // A plane may be met far beyond the distance that the tolerance is meant for.
    const double allowed = tolerance * std::max(1.0, double(truth->t) / (length(Vec3d(ray.o)) + 3));
    out.worst = std::max(out.worst, std::abs(double(Quad(hit.t) - truth->t)) * truth->cosine / allowed);
}

template <class Real>
RayOf<Real> aimed_ray(Random& r, double distance) {
    const Vec3d o = r.direction() * distance;
    return {Vec3<Real>(o), Vec3<Real>(normalize(r.in_box(2) - o))};
}

// Outside at several distances, and inside.
template <class Real>
void check_random_shapes(int which, double largest_distance) {
    constexpr double eps = std::numeric_limits<Real>::epsilon();
    Random r(unsigned(which) + 1);
    Outcome out;
    int rays = 0;
    for (double distance = 0.2; distance <= largest_distance; distance *= 10)
        for (int shape = 0; shape < 20; ++shape) {
            const AnyShape any_shape = test::random_shape(r, which);
            for (int i = 0; i < 25; ++i, ++rays) {
                const RayOf<Real> ray = aimed_ray<Real>(r, distance);
                std::visit(
                    [&](const auto& d) {
                        const auto s = test::cast_shape<Real>(d);
                        const double tolerance = 16 * eps * (distance + 3);
                        check(s, ray, hit_scalar(s, ray), tolerance, out);
                        check(s, ray, hit_lane(s, ray, i % Pack<Real>::width), tolerance, out);
                    },
                    any_shape);
            }
        }
    EXPECT_EQ(out.wrong, 0);
    EXPECT_LE(out.worst, 1);
    EXPECT_GT(out.hits, rays / 8);  // of two checks a ray: triangles are often missed
    EXPECT_LT(out.undecided, rays / 50);
}

class Intersect : public testing::TestWithParam<int> {};
TEST_P(Intersect, DoubleIsExactToRoundingUpToAMillionSizesAway) { check_random_shapes<double>(GetParam(), 3e6); }
TEST_P(Intersect, FloatIsExactToRoundingUpToAThousandSizesAway) { check_random_shapes<float>(GetParam(), 3e3); }
INSTANTIATE_TEST_SUITE_P(EveryShape, Intersect, testing::Range(0, test::shape_variety));

// ---- far, huge, inside, grazing (the cases where the textbook formula fails) ----------------------------------------

struct Errors {
    double t = 0, surface = 0;  // relative to t; | |p| - r | / r
    int wrong = 0;
};

Errors sphere_errors(double radius, const std::vector<RayOf<double>>& rays) {
    Errors e;
    const SphereShape<double> s{radius};
    for (const RayOf<double>& ray : rays) {
        const ShapeHit<double> h = hit_scalar(s, ray);
        const auto truth = first_ahead(test::crossings(s, exact(ray), Vec3d{}));
        if (h.valid != truth.has_value()) ++e.wrong;
        if (!h.valid || !truth) continue;
        e.t = std::max(e.t, std::abs(double((Quad(h.t) - truth->t) / truth->t)));
        const Vec3d p = ray.o + ray.d * h.t;
        e.surface = std::max(e.surface, std::abs(length(p) - radius) / radius);
    }
    return e;
}

TEST(IntersectSphere, IsExactFarAway) {
    for (const double distance : {1e4, 1e6}) {
        Random r(3);
        std::vector<RayOf<double>> rays;
        for (int i = 0; i < 20000; ++i) {
            const Vec3d o = r.direction() * distance;
            rays.push_back({o, normalize(r.in_box(0.57) - o)});  // inside the silhouette: the root is well defined
        }
        const Errors e = sphere_errors(1, rays);
        EXPECT_EQ(e.wrong, 0);
        EXPECT_LE(e.t, 1e-14) << distance;
        EXPECT_LE(e.surface, 1e-9) << distance;
    }
}

TEST(IntersectSphere, AHugeOneIsAFlatGround) {
    constexpr double radius = 1e6, eye = 1.5;
    Random r(4);
    std::vector<RayOf<double>> rays;
    for (int i = 0; i < 20000; ++i) {
        const double arc = std::pow(10, r.uniform(-1, 3)) / radius, turn = r.uniform(0, 6.3);
        const double down = -eye - radius * 2 * std::pow(std::sin(arc / 2), 2), along = radius * std::sin(arc);
        rays.push_back({{0, radius + eye, 0}, normalize(Vec3d{along * std::cos(turn), down, along * std::sin(turn)})});
    }
    const Errors e = sphere_errors(radius, rays);
    EXPECT_EQ(e.wrong, 0);
    EXPECT_LE(e.t, 2e-9);
    // The horizon: the distance at which hits turn into misses, tan of its dip = sqrt(2 R h + h^2) / R.
    double lo = 0, hi = 0.1;  // slope downwards
    for (int i = 0; i < 100; ++i) {
        const double slope = (lo + hi) / 2;
        const RayOf<double> ray{{0, radius + eye, 0}, normalize(Vec3d{1, -slope, 0})};
        (hit_scalar(SphereShape<double>{radius}, ray).valid ? hi : lo) = slope;
    }
    EXPECT_NEAR(radius * hi, std::sqrt(2 * radius * eye + eye * eye), 1e-3);
    EXPECT_NEAR(radius * hi, 1732.05, 1e-2);
}

TEST(IntersectSphere, IsLeftFromInside) {
    Random r(5);
    std::vector<RayOf<double>> rays;
    for (int i = 0; i < 20000; ++i) rays.push_back({r.direction() * r.uniform(0, 0.99), r.direction()});
    const Errors e = sphere_errors(1, rays);
    EXPECT_EQ(e.wrong, 0);
    EXPECT_LE(e.t, 1e-13);
}

TEST(IntersectSphere, DecidesGrazingRaysRightly) {
    Random r(6);
    int hits = 0;
    std::vector<RayOf<double>> rays;
    for (int i = 0; i < 20000; ++i) {
        const Vec3d d = r.direction();
        const Vec3d side = normalize(cross(d, r.direction()));
        rays.push_back({side * (1 + (i % 2 ? 1e-5 : -1e-5)) - d * 10.0, d});
        hits += hit_scalar(SphereShape<double>{1}, rays.back()).valid;
    }
    EXPECT_EQ(sphere_errors(1, rays).wrong, 0);
    EXPECT_EQ(hits, 10000);
}

TEST(IntersectPlane, IsExactToTheHorizon) {
    Random r(7);
    const PlaneShape<double> ground{{0, 1, 0}};
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const double along = std::pow(10, r.uniform(-1, 9)), turn = r.uniform(0, 6.3);
        const RayOf<double> ray{{0, 1.5, 0}, normalize(Vec3d{along * std::cos(turn), -1.5, along * std::sin(turn)})};
        const ShapeHit<double> h = hit_scalar(ground, ray);
        ASSERT_TRUE(h.valid);
        worst = std::max(worst, std::abs(double((Quad(h.t) * -Quad(ray.d.y) - Quad(1.5)) / Quad(1.5))));
    }
    EXPECT_LE(worst, 2e-16);
    EXPECT_FALSE(meet(ground, {{0, 1.5, 0}, {1, 0, 0}}).valid);  // parallel
    EXPECT_FALSE(meet(ground, {{0, 0, 0}, {1, 0, 0}}).valid);    // in it
}

// ---- boxes
// -----------------------------------------------------------------------------------------------------------

TEST(IntersectBox, ANeedleIsHitExactly) {
    const test::Axes a = test::axes_of(quat_from_axis_angle(normalize(Vec3d{1, 2, 3}), 0.7));
    const BoxShape<double> turned{a.x, a.y, a.z, {0.5, 0.5e-6, 0.5e6}};
    const BoxShape<double> straight{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0.5e-6, 0.5e6}};
    Random r(8);
    Outcome out_turned, out_straight;
    for (int i = 0; i < 15000; ++i) {
        const Vec3d target{r.uniform(-0.7, 0.7), r.uniform(-0.7e-6, 0.7e-6), r.uniform(-0.7e6, 0.7e6)};
        const Vec3d o = target + r.direction() * 10.0;
        const RayOf<double> local{o, normalize(target - o)};
        const auto world = [&](const Vec3d& v) { return a.x * v.x + a.y * v.y + a.z * v.z; };
        const RayOf<double> ray{world(local.o), normalize(world(local.d))};
        check(straight, local, hit_scalar(straight, local), 1e-14, out_straight);  // 1e-8 of its smallest side
        check(turned, ray, hit_scalar(turned, ray), 1e-9, out_turned);             // rounding of 1e6
    }
    EXPECT_EQ(out_straight.wrong, 0);
    EXPECT_LE(out_straight.worst, 1);
    EXPECT_LT(out_straight.undecided, 150);
    EXPECT_EQ(out_turned.wrong, 0);
    EXPECT_LE(out_turned.worst, 1);
}

TEST(IntersectBox, RaysInAFaceArePartOfIt) {
    const BoxShape<double> box{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}};
    for (const double side : {-2.0, 2.0}) {
        const ShapeHit<double> h = meet(box, {{-5, side, 0.5}, {1, 0, 0}});
        EXPECT_TRUE(h.valid);
        EXPECT_EQ(h.t, 4);
        EXPECT_EQ(h.part, 1);
        EXPECT_FALSE(meet(box, {{-5, side * (1 + 1e-15), 0.5}, {1, 0, 0}}).valid);
    }
    EXPECT_TRUE(meet(box, {{1, 2, -9}, {0, 0, 1}}).valid);  // along an edge
}

// ---- cylinders
// -------------------------------------------------------------------------------------------------------

CylinderShape<double> cylinder(bool capped) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 2, capped}; }

TEST(IntersectCylinder, RaysAlongTheAxisMeetOnlyTheCaps) {
    const RayOf<double> up{{0.3, 0.4, -5}, {0, 0, 1}};
    const ShapeHit<double> h = hit_scalar(cylinder(true), up);
    EXPECT_TRUE(h.valid);
    EXPECT_EQ(h.t, 3);
    EXPECT_EQ(h.part, part_bottom);
    EXPECT_EQ(h.ng, (Vec3d{0, 0, -1}));
    EXPECT_FALSE(hit_scalar(cylinder(false), up).valid);
    EXPECT_EQ(meet(cylinder(true), {{0.3, 0.4, 0}, {0, 0, 1}}).part, part_top);
    EXPECT_FALSE(meet(cylinder(true), {{0.8, 0.7, -5}, {0, 0, 1}}).valid);
    EXPECT_FALSE(meet(cylinder(true), {{0.3, 0.4, 5}, {0, 0, 1}}).valid);
}

TEST(IntersectCylinder, RaysInACapsPlaneArePartOfIt) {
    for (const double z : {-2.0, 2.0}) {
        const ShapeHit<double> h = meet(cylinder(true), {{-5, 0.5, z}, {1, 0, 0}});
        EXPECT_TRUE(h.valid) << z;
        EXPECT_EQ(h.part, part_side);
        EXPECT_NEAR(h.t, 5 - std::sqrt(0.75), 1e-14);
        EXPECT_FALSE(meet(cylinder(true), {{-5, 0.5, z * (1 + 1e-15)}, {1, 0, 0}}).valid);
    }
}

TEST(IntersectCylinder, AnOpenOneIsSeenFromInside) {
    const RayOf<double> into{{-1.5, 0, 3}, normalize(Vec3d{1, 0, -1})};  // above the near side's edge
    EXPECT_EQ(hit_scalar(cylinder(true), into).part, part_top);
    const ShapeHit<double> h = hit_scalar(cylinder(false), into);
    EXPECT_TRUE(h.valid);
    EXPECT_NEAR(h.t, 2.5 * std::sqrt(2), 1e-14);
    EXPECT_EQ(h.part, part_side);
    EXPECT_NEAR(h.ng.x, 1, 1e-15);
}

TEST(IntersectFlat, RaysInItsPlaneMiss) {
    const FlatShape<double> square = test::flat_shape({}, {1, 0, 0}, {0, 1, 0}, Outline::parallelogram);
    EXPECT_FALSE(meet(square, {{-1, 0.5, 0}, {1, 0, 0}}).valid);
    EXPECT_TRUE(meet(square, {{1, 1, 1}, {0, 0, -1}}).valid);  // a corner belongs to it
}

}  // namespace
}  // namespace drt
