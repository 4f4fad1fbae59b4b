#include "drt/accel/accel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "brute_force.h"

namespace drt {
namespace {

using test::OneHit;
using test::OneRay;
using test::Random;

std::vector<BodyInput> random_scene(Random& r, int bodies, bool moving) {
    std::vector<BodyInput> out;
    for (int i = 0; i < bodies; ++i) {
        const int kind = i % 40 == 39 ? 7 : r.below(7);  // few planes: they hide everything
        BodyInput in{test::random_shape(r, kind), r.in_box(12), {}};
        if (moving && r.below(2)) {
            in.path = test::random_path(r, 1 + r.below(3), r.below(2) == 1);
            for (auto& p : in.path) p.c0 += in.center;
        }
        out.push_back(in);
    }
    return out;
}

template <class Real>
OneRay<Real> random_ray(Random& r) {
    OneRay<Real> ray;
    ray.o = Vec3<Real>(r.in_box(15));
    ray.d = normalize(Vec3<Real>(r.direction()));
    const int which = r.below(8);
    ray.time = which == 0 ? 0.0f : which == 1 ? 1.0f : float(r.uniform(0, 0.999999));
    return ray;
}

struct Compared {
    int rays = 0, hits = 0, wrong = 0, wrong_visibility = 0, blocked = 0;
};

// A packet of rays by the BVH against each ray by all bodies.
template <class Real>
void compare(const Accel<Real>& accel, const BodyTable<Real>& table, const std::vector<OneRay<Real>>& rays,
             Compared& c) {
    // Scalars and lanes may round differently (fused multiply-add): what lies as close as that is not compared.
    constexpr double slack = 64 * std::numeric_limits<Real>::epsilon();
    TraceCounters counters;
    const std::vector<OneHit> found = test::trace(accel, rays, counters);
    EXPECT_EQ(counters.rejected, 0u);
    for (size_t i = 0; i < rays.size(); ++i) {
        ++c.rays;
        std::vector<OneHit> all = test::all_hits(table, rays[i]);
        std::sort(all.begin(), all.end(), [](const OneHit& a, const OneHit& b) { return a.t < b.t; });
        if (all.empty()) {
            c.wrong += found[i].body != no_body;
            continue;
        }
        ++c.hits;
        const OneHit& truth = all.front();
        const bool close = all.size() > 1 && all[1].t - all[0].t < slack * (30 + all[1].t);
        const bool same = found[i].body == truth.body && found[i].part == truth.part &&
                          std::abs(found[i].t - truth.t) <= 1e-3 * (1 + truth.t) &&
                          length(normalize(found[i].ng) - normalize(truth.ng)) < 1e-2;
        c.wrong += !same && !close;
    }
}

template <class Real>
void expect_brute_force(bool moving) {
    Random r(moving ? 2 : 1);
    Compared c;
    for (int scene = 0; scene < 12; ++scene) {
        const auto inputs = random_scene(r, scene == 0 ? 1 : 30 * scene, moving);
        const BuiltTable<Real> built = build_body_table<Real>(inputs);
        const Accel<Real> accel(built.table);
        for (int k = 0; k < 60; ++k) {
            std::vector<OneRay<Real>> rays;
            for (int i = 0; i < Pack<Real>::width - k % 3; ++i) rays.push_back(random_ray<Real>(r));
            compare(accel, built.table, rays, c);
        }
    }
    EXPECT_GT(c.hits, c.rays / 3);
    // Grazing hits that rounding decides differently in lanes and scalars: none are expected in double.
    EXPECT_LE(c.wrong, sizeof(Real) == 8 ? 0 : c.rays / 2000) << c.rays;
}

TEST(Nearest, IsThatOfAllBodiesStandingStillInDouble) { expect_brute_force<double>(false); }
TEST(Nearest, IsThatOfAllBodiesMovingInDouble) { expect_brute_force<double>(true); }
TEST(Nearest, IsThatOfAllBodiesStandingStillInFloat) { expect_brute_force<float>(false); }
TEST(Nearest, IsThatOfAllBodiesMovingInFloat) { expect_brute_force<float>(true); }

template <class Real>
void expect_visibility() {
    Random r(3);
    int wrong = 0, blocked = 0, rays = 0;
    for (int scene = 0; scene < 8; ++scene) {
        const auto inputs = random_scene(r, 40, true);
        const BuiltTable<Real> built = build_body_table<Real>(inputs);
        const Accel<Real> accel(built.table);
        for (int k = 0; k < 2000; ++k, ++rays) {
            OneRay<Real> ray = random_ray<Real>(r);
            ray.tmax = Real(r.uniform(1, 60));
            const int exclude = r.below(41) - 1;
            const auto all = test::all_hits(built.table, ray);
            const bool truth = std::any_of(all.begin(), all.end(), [&](const OneHit& h) { return h.body != exclude; });
            blocked += truth;
            wrong += test::blocked(accel, ray, exclude) != truth;
        }
    }
    EXPECT_GT(blocked, rays / 10);
    EXPECT_LT(blocked, rays * 9 / 10);
    EXPECT_LE(wrong, sizeof(Real) == 8 ? 0 : rays / 2000);
}

TEST(Visibility, IsThatOfAllBodiesInDouble) { expect_visibility<double>(); }
TEST(Visibility, IsThatOfAllBodiesInFloat) { expect_visibility<float>(); }

TEST(Visibility, EndsAtTheGivenDistance) {
    const BuiltTable<double> built = build_body_table<double>(
        {{SphereShape<double>{1}, {5, 0, 0}, {}}, {PlaneShape<double>{{1, 0, 0}}, {-3, 0, 0}, {}}});
    const Accel<double> accel(built.table);
    const auto towards = [](double x, double tmax) { return OneRay<double>{{}, {x, 0, 0}, tmax}; };
    EXPECT_TRUE(test::blocked(accel, towards(1, 4 + 1e-12)));
    EXPECT_FALSE(test::blocked(accel, towards(1, 4 - 1e-12)));
    EXPECT_TRUE(test::blocked(accel, towards(-1, 3 + 1e-12)));
    EXPECT_FALSE(test::blocked(accel, towards(-1, 3 - 1e-12)));
    EXPECT_FALSE(test::blocked(accel, towards(1, 100), 0));
    EXPECT_FALSE(test::blocked(accel, towards(-1, 100), 1));
    EXPECT_TRUE(test::blocked(accel, towards(1, 100), 1));
}

// Bodies seen from 10^4 times their size: Embree walks the BVH with a float copy of the ray, but must not lose corners.
TEST(Nearest, SmallBodiesAreHitFromFarAway) {
    Random r(4);
    constexpr double half = 0.01;
    const BoxShape<double> box{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {half, half, half}};
    std::vector<BodyInput> inputs;  // all near the origin: their coordinates are no larger than they are
    for (int i = 0; i < 20; ++i) inputs.push_back({box, r.in_box(0.05), {}});
    const BuiltTable<double> built = build_body_table<double>(inputs);
    const Accel<double> accel(built.table);
    const auto near_edge = [&] { return (r.below(2) ? half : -half) * (1 - r.uniform(0, 2e-3)); };
    int wrong = 0, hits = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec3d o = r.direction() * 100.0;
        const Vec3d corner = inputs[size_t(r.below(20))].center + Vec3d{near_edge(), near_edge(), near_edge()};
        const OneRay<double> ray{o, normalize(corner - o)};
        const auto all = test::all_hits(built.table, ray);
        const OneHit hit = test::trace(accel, ray);
        hits += hit.body != no_body;
        const auto first =
            std::min_element(all.begin(), all.end(), [](const OneHit& a, const OneHit& b) { return a.t < b.t; });
        wrong += hit.body != (first == all.end() ? no_body : first->body);
    }
    EXPECT_GT(hits, 19000);
    EXPECT_EQ(wrong, 0);
}

// The whole way of a secondary ray: from a hit, out again in any direction, with the BVH and other bodies around.
TEST(Nearest, ClosedBodiesAreNeitherHitAgainNorStuckIn) {
    for (const double offset : {0.0, 1e4, 1e6}) {
        Random r(5);
        std::vector<BodyInput> inputs;
        const Vec3d middle = r.direction() * offset;
        for (int i = 0; i < 27; ++i)  // apart from each other
            inputs.push_back({test::random_shape(r, i % 3 == 0   ? 0
                                                    : i % 3 == 1 ? 4
                                                                 : 5),
                              middle + Vec3d{double(i % 3), double(i / 3 % 3), double(i / 9)} * 15.0,
                              {}});
        const BuiltTable<double> built = build_body_table<double>(inputs);
        const Accel<double> accel(built.table);
        int rays = 0, self = 0, lost = 0;
        while (rays < 30000) {
            const Vec3d o = middle + r.in_box(60);
            const int aim = r.below(27);
            const Vec3d d = normalize(built.table.centers[size_t(aim)] + r.in_box(0.5) - o);
            const OneHit hit = test::trace(accel, OneRay<double>{o, d});
            if (hit.body == no_body || dot(d, hit.ng) >= 0) continue;
            const Vec3d p = o + d * hit.t;
            for (int k = 0; k < 8; ++k, ++rays) {
                const Vec3d next = r.direction();
                const bool outward = dot(next, hit.ng) > 0;
                const OneRay<double> ray{p, next, 1e30, 0, start::pack(hit.body, hit.part, int(outward))};
                const OneHit second = test::trace(accel, ray);
                if (outward) self += second.body == hit.body;
                if (!outward) lost += second.body != hit.body;
            }
        }
        EXPECT_EQ(self, 0) << offset;
        EXPECT_EQ(lost, 0) << offset;
    }
}

TEST(Nearest, MovingBodiesAreThereAtTheFirstAndTheLastInstant) {
    MotionPiece<double> p;
    p.c1 = {10, 0, 0};
    const BuiltTable<float> built = build_body_table<float>({{SphereShape<double>{1}, {}, {p}}});
    const Accel<float> accel(built.table);
    for (const float time : {0.0f, 0.5f, 1.0f}) {
        const OneRay<float> ray{{10 * time, 0, 5}, {0, 0, -1}, 1e30f, time};
        EXPECT_EQ(test::trace(accel, ray).body, 0) << time;
        EXPECT_TRUE(test::blocked(accel, ray)) << time;
    }
}

// ---- scenes of nothing, of planes, of one body
// -----------------------------------------------------------------------

TEST(SmallScenes, NothingIsHitWhereNothingIs) {
    const BuiltTable<float> built = build_body_table<float>({});
    const Accel<float> accel(built.table);
    EXPECT_EQ(test::trace(accel, OneRay<float>{{}, {1, 0, 0}}).body, no_body);
    EXPECT_FALSE(test::blocked(accel, OneRay<float>{{}, {1, 0, 0}}));
    EXPECT_EQ(accel.memory(), 0u);
}

TEST(SmallScenes, PlanesAloneNeedNoBvh) {
    MotionPiece<double> rising;
    rising.c0 = {0, -2, 0};
    rising.c1 = {0, 1, 0};
    const BuiltTable<double> built = build_body_table<double>(
        {{PlaneShape<double>{{0, 1, 0}}, {0, -3, 0}, {}}, {PlaneShape<double>{{0, 1, 0}}, {}, {rising}}});
    const Accel<double> accel(built.table);
    EXPECT_EQ(accel.memory(), 0u);
    const auto down = [](float time) { return OneRay<double>{{}, {0, -1, 0}, 1e30, time}; };
    EXPECT_EQ(test::trace(accel, down(0)).t, 2);
    EXPECT_EQ(test::trace(accel, down(1)).t, 1);
    EXPECT_TRUE(test::blocked(accel, down(0.5)));
    const OneRay<double> slanting{{}, normalize(Vec3d{1, -1e-9, 0})};  // far away, exact all the same
    EXPECT_NEAR(test::trace(accel, slanting).t, 2e9, 1e-6);
}

TEST(SmallScenes, OneBodyOfEachKindIsFound) {
    Random r(6);
    for (int kind = 0; kind < 7; ++kind) {
        const BuiltTable<float> built = build_body_table<float>({{test::random_shape(r, kind), {0, 0, -10}, {}}});
        const Accel<float> accel(built.table);
        int hits = 0;
        for (int i = 0; i < 1000; ++i) {
            const OneRay<float> ray{{}, Vec3f(normalize(Vec3d{0, 0, -10} + r.in_box(2)))};
            hits += test::trace(accel, ray).body == 0;
        }
        EXPECT_GT(hits, 0) << kind;
    }
}

// ---- rays that Embree must not see
// -----------------------------------------------------------------------------------

template <class Real>
void expect_rejected() {
    const BuiltTable<Real> built = build_body_table<Real>(
        {{SphereShape<double>{1}, {5, 0, 0}, {}}, {PlaneShape<double>{{1, 0, 0}}, {9, 0, 0}, {}}});
    const Accel<Real> accel(built.table);
    constexpr Real inf = std::numeric_limits<Real>::infinity(), nan = std::numeric_limits<Real>::quiet_NaN();
    const OneRay<Real> good{{}, {1, 0, 0}};
    std::vector<OneRay<Real>> bad;
    for (const Real v : {nan, inf, -inf, Real(2e18), Real(-2e18)})
        for (int axis = 0; axis < 3; ++axis) {
            OneRay<Real> o = good, d = good;
            (axis == 0 ? o.o.x : axis == 1 ? o.o.y : o.o.z) = v;
            (axis == 0 ? d.d.x : axis == 1 ? d.d.y : d.d.z) = v;
            bad.insert(bad.end(), {o, d});
        }
    bad.push_back({{}, {0, 0, 0}});
    bad.push_back({{}, {2, 0, 0}});
    bad.push_back({{}, {1, 0, 0}, nan});
    bad.push_back({{}, {1, 0, 0}, -1});
    for (const float time : {-0.001f, 1.001f, std::numeric_limits<float>::quiet_NaN()})
        bad.push_back({{}, {1, 0, 0}, inf, time});
    std::uint64_t expected = 0;
    TraceCounters counters;
    for (const OneRay<Real>& b : bad) {  // next to a good ray, which is not harmed
        const std::vector<OneRay<Real>> two{b, good};
        const auto hits = test::trace(accel, two, counters);
        EXPECT_EQ(counters.rejected, ++expected);
        EXPECT_EQ(hits[0].body, no_body);
        EXPECT_EQ(hits[1].body, 0);
        const auto hidden = accel.occluded(test::packet(two), typename Pack<Real>::I(-1), counters);
        EXPECT_EQ(counters.rejected, ++expected);
        EXPECT_FALSE(lane_bit(hidden, 0));
        EXPECT_TRUE(lane_bit(hidden, 1));
    }
}

TEST(Rejected, RaysAreCountedAndMissInFloat) { expect_rejected<float>(); }
TEST(Rejected, RaysAreCountedAndMissInDouble) { expect_rejected<double>(); }

}  // namespace
}  // namespace drt
