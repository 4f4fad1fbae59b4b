// Rays that start on the shape they left: the root that belongs to the start is never found, the exit always is.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <limits>

#include "drt/geometry/intersect.h"
#include "exact_shapes.h"
#include "random_shapes.h"

namespace drt {
namespace {

using test::Crossing;
using test::Quad;
using test::Random;

bool encloses(const SphereShape<double>&) { return true; }
bool encloses(const BoxShape<double>&) { return true; }
bool encloses(const CylinderShape<double>& s) { return s.capped; }
template <class Shape>
bool encloses(const Shape&) {
    return false;
}

struct Counts {
    int rays = 0, inward = 0, self_hits = 0, lost_exits = 0, wrong_exits = 0, checked = 0;
};

template <class Real>
struct Ground {
    Vec3<Real> p, n;  // a point of the surface as the renderer computes it, and the normal there
    int part;
};

// Between where a slightly smaller and a slightly larger body would be left: along a face, they may lie far apart.
template <class Shape, class Real>
bool exit_is_right(const Shape& s, const Vec3<Real>& o, const Vec3<Real>& d, const ShapeHit<Real>& hit, double error,
                   double cos_start) {
    const test::Ray ray{{Quad(o.x), Quad(o.y), Quad(o.z)}, {Quad(d.x), Quad(d.y), Quad(d.z)}};
    // A grazing start makes the exit's distance, and with it the height on a cylinder's side, less certain.
    const Vec3d grow = Vec3d{1, 1, 4 / cos_start} * error;
    const auto smaller = test::crossings(s, ray, -grow);
    const auto larger = test::crossings(s, ray, grow);
    if (larger.empty()) return hit.t <= 2 * std::sqrt(error);
    const double lo = smaller.empty() ? 0 : double(smaller.back().t);
    const double tolerance = 8 * error / std::min(cos_start, larger.back().cosine);
    return hit.t >= lo - tolerance && hit.t <= double(larger.back().t) + tolerance;
}

template <class Real, class Shape>
void leave(const Shape& exact_shape, const Vec3d& center_d, const Ground<Real>& g, Random& r, double error, Counts& c) {
    using R = typename Pack<Real>::R;
    using I = typename Pack<Real>::I;
    const auto s = test::cast_shape<Real>(exact_shape);
    const Vec3<Real> center(center_d);
    Vec3<R> d;
    for (int i = 0; i < Pack<Real>::width; ++i) {
        const Vec3<Real> v(r.direction());
        d.x[i] = v.x, d.y[i] = v.y, d.z[i] = v.z;
    }
    const auto outward = dot(d, Vec3<R>(g.n)) > R(0);
    const Vec3<Real> o = g.p - center;
    const Relation<R> rel{MaskOf<R>(true), outward, I(g.part)};
    const ShapeHit<R> hit = intersect<R>(s, Vec3<R>(o), d, rel, R(0), R(std::numeric_limits<Real>::infinity()));
    for (int i = 0; i < Pack<Real>::width; ++i) {
        ++c.rays;
        const bool valid = lane_bit(hit.valid, i), out = lane_bit(outward, i);
        if (out || std::is_same_v<Shape, FlatShape<double>> || std::is_same_v<Shape, PlaneShape<double>>) {
            c.self_hits += valid;
            continue;
        }
        ++c.inward;
        const Vec3<Real> di{lane(d.x, i), lane(d.y, i), lane(d.z, i)};
        if (encloses(exact_shape)) c.lost_exits += !valid;
        if (!valid || i != 0) continue;
        ++c.checked;
        const ShapeHit<Real> one{true, lane(hit.t, i), {}, lane(hit.part, i)};
        c.wrong_exits += !exit_is_right(s, o, di, one, error, std::abs(double(dot(di, g.n))));
    }
}

/// From `starts` random points on each of 8 kinds of shape at this distance from the origin of coordinates, a packet
/// of directions each.
template <class Real>
Counts leave_shapes(double offset, int starts, unsigned seed) {
    Counts c;
    Random r(seed);
    for (int k = 0; k < starts; ++k) {
        const AnyShape shape = test::random_shape(r, k % test::shape_variety);
        const Vec3d center(Vec3<Real>(r.direction() * offset));
        const Vec3<Real> eye(center + r.direction() * 10.0);
        const Vec3<Real> d = normalize(Vec3<Real>(center + r.in_box(1)) - eye);
        std::visit(
            [&](const auto& exact_shape) {
                const auto s = test::cast_shape<Real>(exact_shape);
                const Relation<Real> free{false, false, 0};
                const ShapeHit<Real> h = intersect<Real>(s, eye - Vec3<Real>(center), d, free, Real(0),
                                                         std::numeric_limits<Real>::infinity());
                if (!h.valid) return;
                const double error = 8 * double(std::numeric_limits<Real>::epsilon()) * (offset + 15);
                leave<Real>(exact_shape, center, {eye + d * h.t, normalize(h.ng), h.part}, r, error, c);
            },
            shape);
    }
    return c;
}

// As many shapes as are worth so many rays, on a machine of any width.
template <class Real>
constexpr int shapes_for(int rays) {
    return rays / Pack<Real>::width;
}

void expect_faultless(const Counts& c, double offset) {
    EXPECT_EQ(c.self_hits, 0) << offset;
    EXPECT_EQ(c.lost_exits, 0) << offset;
    EXPECT_EQ(c.wrong_exits, 0) << offset << ", of " << c.checked;
    EXPECT_GT(c.checked, 100);
}

TEST(Start, NoSelfHitsAndNoLostExitsInDouble) {
    std::int64_t rays = 0;
    unsigned seed = 1;
    for (const double offset : {0.0, 1.0, 1e2, 1e4, 1e6}) {
        const Counts c = leave_shapes<double>(offset, shapes_for<double>(480000), seed++);
        expect_faultless(c, offset);
        rays += c.rays;
    }
    EXPECT_GT(rays, 1'000'000);
    RecordProperty("rays", std::to_string(rays));
}

TEST(Start, NoSelfHitsAndNoLostExitsInFloatWithinItsRange) {
    std::int64_t rays = 0;
    unsigned seed = 11;
    for (const double offset : {0.0, 1.0, 1e2, 3e3}) {  // sizes are 1/3 to 3: the plan's limit is 1e4 sizes
        const Counts c = leave_shapes<float>(offset, shapes_for<float>(640000), seed++);
        expect_faultless(c, offset);
        rays += c.rays;
    }
    EXPECT_GT(rays, 1'000'000);
}

TEST(Start, ASphereIsLeftAtTheEndOfTheChord) {
    Random r(21);
    for (const double offset : {0.0, 1e6}) {
        const Vec3d center = r.direction() * offset;
        double worst = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec3d p = center + r.direction() * 2.0;  // rounded to the coordinates' grid
            const Vec3d o = p - center;
            const Vec3d d = r.direction();
            const double cosine = -dot(o, d) / length(o);
            if (cosine <= 0) continue;
            const ShapeHit<double> h = intersect<double>(SphereShape<double>{2}, o, d, {true, false, 0}, 0.0, 1e30);
            ASSERT_TRUE(h.valid);
            worst = std::max(worst, std::abs(h.t - 4 * cosine));
        }
        EXPECT_LE(worst, offset == 0 ? 2e-15 : 1e-9) << offset;
    }
}

// Why there is no fixed distance to keep: too small and rays hit where they start, too large and they miss the exit.
TEST(Start, AnyFixedDistanceFails) {
    for (const float tmin : {1e-5f, 1e-4f, 1e-3f, 1e-2f}) {
        int self_hits = 0, lost = 0, rays = 0;
        Random r(31);
        for (const double offset : {0.0, 1e2, 3e3})
            for (int i = 0; i < 20000; ++i, ++rays) {
                const Vec3f center(r.direction() * offset);
                const Vec3f eye = center + Vec3f(r.direction() * 10.0);
                const Vec3f d = normalize(center + Vec3f(r.in_box(0.5)) - eye);
                const SphereShape<float> s{1};
                const Relation<float> free{false, false, 0};
                const ShapeHit<float> h = intersect<float>(s, eye - center, d, free, 0.0f, 1e30f);
                const Vec3f o = eye + d * h.t - center, next(r.direction());
                const bool hit = intersect<float>(s, o + next * tmin, next, free, 0.0f, 1e30f).valid;
                const bool outward = dot(next, o) > 0;
                self_hits += outward && hit;
                lost += !outward && !hit;
            }
        EXPECT_GT(self_hits + lost, 0) << tmin;
        std::printf("tmin %g: %.3f %% hit where they start, %.3f %% miss the exit\n", double(tmin),
                    100.0 * self_hits / rays, 100.0 * lost / rays);
    }
}

TEST(Start, AnOpenCylinderIsLeftThroughItsFarSideOrItsEnds) {
    const CylinderShape<double> s{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 2, false};
    const Relation<double> inward{true, false, part_side};
    EXPECT_NEAR(intersect<double>(s, {1, 0, 0}, normalize(Vec3d{-1, 0, 0.5}), inward, 0.0, 1e30).t, std::sqrt(5.0),
                1e-14);
    EXPECT_FALSE(intersect<double>(s, {1, 0, 0}, normalize(Vec3d{-1, 0, 1.5}), inward, 0.0, 1e30).valid);
}

TEST(Start, PackingKeepsBodyPartAndSide) {
    for (const int body : {0, 1, 12345, (1 << 27) - 1})
        for (int part = 0; part < 6; ++part)
            for (const int outward : {0, 1}) {
                const int s = start::pack(body, part, outward);
                EXPECT_GE(s, 0);
                EXPECT_EQ(start::body(s), body);
                EXPECT_EQ(start::part(s), part);
                EXPECT_EQ(start::outward(s), outward == 1);
            }
}

// ---- the packed form -----------------------------------------------------------------------------------------------

// Every field by its bits, whatever the others are: lanes without a hit hold anything, which must neither overflow (the
// undefined-behaviour sanitizer looks on) nor carry into its neighbours.
int packed_bits(int body, int part, int outward) {
    const auto bits = [](int v) { return std::uint32_t(v); };
    return int((bits(body) << 4) | (bits(part) << 1) | bits(outward));
}

constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
constexpr int extremes[] = {least, least + 1, -2, -1, 0, 1, 2, 7, 8, 15, 16, (1 << 27) - 1, 1 << 27, most - 1, most};

TEST(PackedStart, IsMadeOfTheBitsOfItsFields) {
    using I = Pack<float>::I;
    for (const int body : extremes)
        for (const int part : extremes)
            for (const int outward : extremes) {
                const int expected = packed_bits(body, part, outward);
                ASSERT_EQ(start::pack(body, part, outward), expected) << body << ' ' << part << ' ' << outward;
                I lanes_of_body(0), lanes_of_part(0), lanes_of_outward(0);  // a hit beside lanes that hold anything
                lanes_of_body[0] = body, lanes_of_part[0] = part, lanes_of_outward[0] = outward;
                const I lanes = start::pack(lanes_of_body, lanes_of_part, lanes_of_outward);
                ASSERT_EQ(int(lanes[0]), expected);
                for (int i = 1; i < Pack<float>::width; ++i) ASSERT_EQ(int(lanes[i]), 0);
            }
}

TEST(PackedStart, GivesItsFieldsBack) {
    for (const int body : {0, 1, 12345, (1 << 27) - 1})
        for (int part = 0; part < 6; ++part)
            for (const int outward : {0, 1}) {
                const int s = start::pack(body, part, outward);
                EXPECT_NE(s, start::none);
                EXPECT_EQ(start::body(s), body);
                EXPECT_EQ(start::part(s), part);
                EXPECT_EQ(start::outward(s), outward == 1);
            }
}

}  // namespace
}  // namespace drt
