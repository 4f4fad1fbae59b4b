// Surfaces that touch: each is met once, in the right order, whatever the bodies' kinds, their order, place, size and
// turn, and the precision.

#include <gtest/gtest.h>

#include <algorithm>

#include "brute_force.h"

namespace drt {
namespace {

using test::OneDeparture;
using test::OneHit;
using test::OneRay;
using test::Random;

// A similarity: where a test's scene is put.
struct Placing {
    test::Axes axes;
    Vec3d middle;
    double size;

    Vec3d direction(const Vec3d& v) const { return axes.x * v.x + axes.y * v.y + axes.z * v.z; }
    Vec3d point(const Vec3d& v) const { return middle + direction(v) * size; }
};

// Anywhere near, far away as against its size, and without any turn, as most scenes are.
Placing random_placing(Random& r) {
    const Quatd turn = r.below(3) == 0 ? Quatd{} : r.turn();
    const double size = r.scale(1000);
    return {test::axes_of(turn), r.direction() * (r.below(2) ? 0.0 : r.uniform(0, 30) * size), size};
}

// A body of a test, in its own coordinates.
struct Piece {
    enum Kind { box, drum, ground, sheet, ball } kind;
    Vec3d middle;
    Vec3d half;  // box: half extents; drum: radius, -, half height along z; ball: radius; sheet: half sides along x, y
    int rank;
    bool refracts;
    bool far_side = false;  // of a sheet or ground: its normal is -z instead of z
};

BodyInput placed(const Piece& s, const Placing& p) {
    const test::Axes& a = p.axes;
    const double k = p.size;
    const Vec3d up = s.far_side ? -a.z : a.z;
    const auto shape = [&]() -> AnyShape {
        switch (s.kind) {
            case Piece::box:
                return BoxShape<double>{a.x, a.y, a.z, s.half * k};
            case Piece::drum:
                return CylinderShape<double>{a.x, a.y, a.z, s.half.x * k, s.half.z * k, true};
            case Piece::ground:
                return PlaneShape<double>{up};
            case Piece::sheet: {
                const Vec3d e0 = a.x * (2 * s.half.x * k), e1 = (s.far_side ? -a.y : a.y) * (2 * s.half.y * k);
                return test::flat_shape((e0 + e1) * -0.5, e0, e1, Outline::parallelogram);
            }
            case Piece::ball:
                break;
        }
        return SphereShape<double>{s.half.x * k};
    };
    return {shape(), p.point(s.middle), {}, {s.rank, s.refracts}};
}

// A path, and what it has met.
template <class Real>
class Walk {
public:
    Walk(const Accel<Real>& accel, const std::vector<int>& order, const Vec3d& o, const Vec3d& d)
        : accel_(accel), order_(order), ray_{Vec3<Real>(o), normalize(Vec3<Real>(d))} {}

    /// To the next surface; false if there is none. The piece's number and whether the ray ran into it (against its
    /// normal) are `met` and `entering`.
    bool next() {
        const OneHit hit = from_ ? test::trace(accel_, ray_, from_.get()) : test::trace(accel_, ray_);
        if (hit.body == no_body) return false;
        body_ = hit.body;
        part_ = hit.part;
        normal_ = hit.ng;
        met = order_[size_t(hit.body)];
        entering = dot(Vec3d(ray_.d), hit.ng) < 0;
        point_ = ray_.o + ray_.d * Real(hit.t);
        distance_ = Real(hit.t);
        return true;
    }

    /// Through the surface, into or out of it.
    void cross(bool refracts) {
        if (refracts && entering) media_.push_back(body_);
        if (refracts && !entering) std::erase(media_, body_);
        leave(ray_.d, !entering);
    }

    /// Back from the surface, in a direction on the side from which the path came.
    void turn_back(const Vec3<Real>& d) { leave(d, entering); }

    Vec3d normal() const { return normalize(normal_) * (entering ? 1.0 : -1.0); }
    const Vec3<Real>& direction() const { return ray_.d; }
    const OneRay<Real>& ray() const { return ray_; }
    const OneDeparture<Real>* from() const { return from_.get(); }

    int met = -1;
    bool entering = false;

private:
    void leave(const Vec3<Real>& d, bool outward) {
        Arrival<Real> arrival{ray_.d, distance_, ray_.start};
        const Real reach = largest_coordinate(point_);
        if (from_ && is_hop(distance_, ray_.start, reach, from_->travelled[0])) {
            arrival.d = {from_->dx[0], from_->dy[0], from_->dz[0]};
            arrival.travelled += from_->travelled[0];
        }
        from_ = std::make_unique<OneDeparture<Real>>(arrival.d, arrival.travelled, arrival.came_from, media_);
        ray_.o = point_;
        ray_.d = d;
        ray_.start = start::pack(body_, part_, outward ? 1 : 0);
    }

    const Accel<Real>& accel_;
    const std::vector<int>& order_;
    OneRay<Real> ray_;
    std::unique_ptr<OneDeparture<Real>> from_;
    std::vector<std::int32_t> media_;
    int body_ = no_body, part_ = 0;
    Vec3d normal_;
    Vec3<Real> point_;
    Real distance_ = 0;
};

// What a path that goes straight through everything meets, as text: "+0" enters piece 0, "-0" leaves it.
template <class Real>
std::string meetings(const std::vector<Piece>& pieces, const Accel<Real>& accel, const std::vector<int>& order,
                     const Vec3d& o, const Vec3d& d) {
    std::string out;
    Walk<Real> walk(accel, order, o, d);
    for (int i = 0; i < 50 && walk.next(); ++i) {
        out += (walk.entering ? " +" : " -") + std::to_string(walk.met);
        walk.cross(pieces[size_t(walk.met)].refracts);
    }
    return out;
}

// Pieces in random order, placed at random; paths from above (positive z) to below and back, within |x|, |y| < 0.4.
template <class Real>
void expect_meetings(const std::vector<Piece>& pieces, const std::string& downward, const std::string& upward) {
    Random r(7);
    int wrong = 0;
    std::string example;
    for (int k = 0; k < 300; ++k) {
        const Placing placing = random_placing(r);
        std::vector<int> shuffled(pieces.size());
        for (size_t i = 0; i < pieces.size(); ++i) shuffled[i] = int(i);
        for (size_t i = pieces.size(); i > 1; --i) std::swap(shuffled[i - 1], shuffled[size_t(r.below(int(i)))]);
        std::vector<BodyInput> inputs;
        for (const int i : shuffled) inputs.push_back(placed(pieces[size_t(i)], placing));
        const BuiltTable<Real> built = build_body_table<Real>(inputs);
        std::vector<int> order;
        for (const int source : built.order) order.push_back(shuffled[size_t(source)]);
        const Accel<Real> accel(built.table);
        for (int ray = 0; ray < 20; ++ray) {
            const Vec3d a{r.uniform(-0.4, 0.4), r.uniform(-0.4, 0.4), 9},
                b{r.uniform(-0.4, 0.4), r.uniform(-0.4, 0.4), -9};
            const Vec3d top = placing.point(a), bottom = placing.point(b);
            const std::string down = meetings(pieces, accel, order, top, bottom - top);
            const std::string up = meetings(pieces, accel, order, bottom, top - bottom);
            wrong += (down != downward) + (up != upward);
            if (down != downward) example = "down:" + down;
            if (up != upward) example = "up:" + up;
        }
    }
    EXPECT_EQ(wrong, 0) << "of 12000; for example " << example;
}

void expect_meetings_in_both(const std::vector<Piece>& pieces, const std::string& downward, const std::string& upward) {
    expect_meetings<double>(pieces, downward, upward);
    expect_meetings<float>(pieces, downward, upward);
}

const Vec3d block{1, 1, 1};

TEST(Contact, GlassOnTheGround) {  // the ground is met within the glass
    for (const auto kind : {Piece::box, Piece::drum})
        for (const bool far_side : {false, true})
            for (const auto ground : {Piece::ground, Piece::sheet})
                for (const int rank : {0, 2}) {
                    const std::string down = far_side ? " -1" : " +1", up = far_side ? " +1" : " -1";
                    expect_meetings_in_both(
                        {{kind, {0, 0, 1}, block, rank, true}, {ground, {0, 0, 0}, {3, 3, 0}, 1, false, far_side}},
                        " +0" + down + " -0", up + " +0 -0");
                }
}

TEST(Contact, GlassOnATable) {  // contact is overlap: the table begins before the glass ends
    for (const auto glass : {Piece::box, Piece::drum})
        for (const auto table : {Piece::box, Piece::drum})
            for (const int rank : {0, 2})
                expect_meetings_in_both(
                    {{glass, {0, 0, 1}, block, rank, true}, {table, {0, 0, -1.5}, {2, 2, 1.5}, 1, false}},
                    " +0 +1 -0 -1", " +1 +0 -1 -0");
}

TEST(Contact, GlassOnGlass) {
    for (const auto upper : {Piece::box, Piece::drum})
        for (const auto lower : {Piece::box, Piece::drum})
            for (const int rank : {0, 2})
                expect_meetings_in_both({{upper, {0, 0, 1}, block, rank, true}, {lower, {0, 0, -1}, block, 1, true}},
                                        " +0 +1 -0 -1", " +1 +0 -1 -0");
}

TEST(Contact, AStackOfThreeOnTheGround) {
    expect_meetings_in_both({{Piece::box, {0, 0, 5}, block, 2, true},
                             {Piece::drum, {0, 0, 3}, block, 0, true},
                             {Piece::box, {0, 0, 1}, block, 1, true},
                             {Piece::ground, {0, 0, 0}, {}, 3, false}},
                            " +0 +1 -0 +2 -1 +3 -2", " -3 +2 +1 -2 +0 -1 -0");
}

TEST(Contact, TheOwnerOfACommonFaceIsEnteredFirstAndLeftLast) {
    // The lower ends of both are at z = 0, and 0 outranks 1.
    expect_meetings_in_both({{Piece::box, {0, 0, 1}, block, 0, true}, {Piece::drum, {0, 0, 2}, {2, 2, 2}, 1, true}},
                            " +1 +0 -1 -0", " +0 +1 -0 -1");
}

TEST(Contact, BallsInTheSamePlace) {
    expect_meetings_in_both(
        {{Piece::ball, {0, 0, 0}, {2, 0, 0}, 1, true}, {Piece::ball, {0, 0, 0}, {2, 0, 0}, 0, true}}, " +1 +0 -0 -1",
        " +1 +0 -0 -1");
}

TEST(Contact, ASheetLiesOnTopOnEitherSide) {
    for (const bool refracts : {false, true})
        expect_meetings_in_both(
            {{Piece::box, {0, 0, -1}, block, 0, refracts}, {Piece::sheet, {0, 0, 0}, {3, 3, 0}, 1, false}}, " +1 +0 -0",
            refracts ? " +0 -1 -0" : " +0 -1 -0");
}

TEST(Contact, OfTwoSheetsTheLowerRankIsMetFirst) {
    expect_meetings_in_both(
        {{Piece::sheet, {0, 0, 0}, {3, 3, 0}, 1, false}, {Piece::sheet, {0, 0, 0}, {2, 2, 0}, 0, false}}, " +1 +0",
        " -1 -0");
}

// Reflection at a floor under glass leads up through the glass, and to nothing else.
template <class Real>
void expect_way_back(const Piece& floor) {
    Random r(8);
    int wrong = 0, paths = 0;
    for (int k = 0; k < 300; ++k) {
        const Placing placing = random_placing(r);
        const Piece glass{Piece::box, {0, 0, 1}, block, k % 2 * 2, true};
        const bool glass_first = r.below(2) == 0;
        const BodyInput a = placed(glass, placing), b = placed(floor, placing);
        const BuiltTable<Real> built = build_body_table<Real>(glass_first ? std::vector{a, b} : std::vector{b, a});
        std::vector<int> order;
        for (const int source : built.order) order.push_back(glass_first ? source : 1 - source);
        const Accel<Real> accel(built.table);
        for (int ray = 0; ray < 20; ++ray) {
            const Vec3d top = placing.point({r.uniform(-0.4, 0.4), r.uniform(-0.4, 0.4), 9});
            const Vec3d aim = placing.point({r.uniform(-0.4, 0.4), r.uniform(-0.4, 0.4), 0});
            Walk<Real> walk(accel, order, top, aim - top);
            wrong += !(walk.next() && walk.met == 0 && walk.entering);
            walk.cross(true);
            wrong += !(walk.next() && walk.met == 1);
            Vec3d up = r.direction();
            if (dot(up, walk.normal()) < 0) up = -up;
            walk.turn_back(normalize(Vec3<Real>(up)));
            const OneRay<Real> shadow = walk.ray();
            wrong += !test::blocked(accel, shadow, -1, walk.from());
            wrong += test::blocked(accel, shadow, glass_first == (built.order[0] == 0) ? 0 : 1, walk.from());
            wrong += !(walk.next() && walk.met == 0 && !walk.entering);
            walk.cross(true);
            wrong += walk.next();
            ++paths;
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << paths;
}

TEST(Contact, AFloorReflectsBackThroughTheGlass) {
    for (const Piece& floor :
         {Piece{Piece::ground, {}, {}, 1, false}, Piece{Piece::sheet, {}, {3, 3, 0}, 1, false},
          Piece{Piece::box, {0, 0, -2}, {3, 3, 2}, 1, false}, Piece{Piece::drum, {0, 0, -2}, {3, 3, 2}, 1, false}}) {
        expect_way_back<float>(floor);
        expect_way_back<double>(floor);
    }
}

// ---- closed rooms ---------------------------------------------------------------------------------------------------

using Room = std::vector<BodyInput>;

// The room -1..1 in x, y and z.
Room room_of_sheets(const Placing& p, Outline outline, double overlap) {
    Room out;
    const double h = (1 + overlap) * p.size;
    const Vec3d axes[] = {p.axes.x, p.axes.y, p.axes.z};
    for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0}) {
            const Vec3d u = axes[(i + 1) % 3] * h, v = axes[(i + 2) % 3] * (side * h);
            const Vec3d center = p.middle + axes[i] * (side * p.size);
            if (outline == Outline::parallelogram) {
                out.push_back(
                    {test::flat_shape(-u - v, u * 2.0, v * 2.0, outline), center, {}, {int(out.size()), false}});
            } else {  // two triangles
                out.push_back(
                    {test::flat_shape(-u - v, u * 2.0, v * 2.0, outline), center, {}, {int(out.size()), false}});
                out.push_back(
                    {test::flat_shape(u + v, u * -2.0, v * -2.0, outline), center, {}, {int(out.size()), false}});
            }
        }
    return out;
}

// Walls of thickness 0.2 around it. `abut`: side by side, each ends where the next one begins; else they overlap.
Room room_of_boxes(const Placing& p, bool abut) {
    Room out;
    const test::Axes& a = p.axes;
    const Vec3d axes[] = {a.x, a.y, a.z};
    for (int i = 0; i < 3; ++i)
        for (const double side : {-1.0, 1.0}) {
            const auto reach = [&](int along) { return along == i ? 0.1 : abut && along > i ? 1.0 : 1.2; };
            out.push_back({BoxShape<double>{a.x, a.y, a.z, Vec3d{reach(0), reach(1), reach(2)} * p.size},
                           p.middle + axes[i] * (side * 1.1 * p.size),
                           {},
                           {int(out.size()), false}});
        }
    return out;
}

Room room_of_planes(const Placing& p) {
    Room out;
    for (const Vec3d& n : {p.axes.x, p.axes.y, p.axes.z})
        for (const double side : {-1.0, 1.0})
            out.push_back(
                {PlaneShape<double>{n * -side}, p.middle + n * (side * p.size), {}, {int(out.size()), false}});
    return out;
}

Room room_of_a_box(const Placing& p) {
    return {{BoxShape<double>{p.axes.x, p.axes.y, p.axes.z, block * p.size}, p.middle, {}, {0, false}}};
}

Room room_of_a_tube(const Placing& p) {
    const test::Axes& a = p.axes;
    const double k = p.size;
    return {{CylinderShape<double>{a.x, a.y, a.z, 1 * k, 1 * k, false}, p.middle, {}, {0, false}},
            {test::flat_shape({}, a.x * k, a.y * k, Outline::disc), p.middle + a.z * k, {}, {1, false}},
            {test::flat_shape({}, a.x * k, a.y * k, Outline::disc), p.middle - a.z * k, {}, {2, false}}};
}

// Near an edge, on one, in a corner, or anywhere.
double coordinate(Random& r) {
    const double away[] = {0, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3};
    if (r.below(2)) return r.uniform(-1, 1);
    return (r.below(2) ? 1 : -1) * (1 - away[r.below(7)] * r.uniform(0, 1));
}

// Paths that bounce around, at edges and corners mostly, and never get out.
template <class Real, class MakeRoom>
void expect_closed(MakeRoom make_room, int rooms = 60) {
    Random r(9);
    int escaped = 0, bounces = 0;
    for (int k = 0; k < rooms; ++k) {
        const Placing placing = random_placing(r);
        const Room room = make_room(placing);
        const BuiltTable<Real> built = build_body_table<Real>(room);
        const Accel<Real> accel(built.table);
        const bool round = std::holds_alternative<CylinderShape<double>>(room[0].shape);
        const auto aim = [&] {
            Vec3d p{coordinate(r), coordinate(r), coordinate(r)};
            if (!round) return placing.point(p);
            const double turn = r.uniform(0, 6.3), radius = std::abs(p.x);
            return placing.point({radius * std::cos(turn), radius * std::sin(turn), p.z});
        };
        for (int path = 0; path < 300; ++path) {
            Vec3d inside{r.uniform(-0.6, 0.6), r.uniform(-0.6, 0.6), r.uniform(-0.6, 0.6)};
            Walk<Real> walk(accel, built.order, placing.point(inside), aim() - placing.point(inside));
            for (int bounce = 0; bounce < 8; ++bounce, ++bounces) {
                if (!walk.next()) {
                    ++escaped;
                    break;
                }
                Vec3d d = r.below(2) ? r.direction() : normalize(aim() - placing.point(inside));
                if (dot(d, walk.normal()) < 0) d = d - walk.normal() * (2 * dot(d, walk.normal()));
                walk.turn_back(normalize(Vec3<Real>(d)));
                escaped += !test::blocked(accel, walk.ray(), -1, walk.from());
            }
        }
    }
    EXPECT_EQ(escaped, 0) << "of " << bounces;
}

template <class MakeRoom>
void expect_closed_in_both(MakeRoom make_room) {
    expect_closed<float>(make_room);
    expect_closed<double>(make_room);
}

TEST(ClosedRoom, OfRectangles) {
    for (const double overlap : {0.0, 0.1})
        expect_closed_in_both([&](const Placing& p) { return room_of_sheets(p, Outline::parallelogram, overlap); });
}
TEST(ClosedRoom, OfTriangles) {
    expect_closed_in_both([](const Placing& p) { return room_of_sheets(p, Outline::triangle, 0); });
}
TEST(ClosedRoom, OfBoxes) {
    for (const bool abut : {false, true})
        expect_closed_in_both([&](const Placing& p) { return room_of_boxes(p, abut); });
}
TEST(ClosedRoom, OfPlanes) { expect_closed_in_both(room_of_planes); }
TEST(ClosedRoom, WithinABox) { expect_closed_in_both(room_of_a_box); }
TEST(ClosedRoom, OfATubeAndDiscs) { expect_closed_in_both(room_of_a_tube); }

}  // namespace
}  // namespace drt
