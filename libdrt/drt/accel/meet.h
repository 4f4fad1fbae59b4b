#pragma once
// One body against one ray, or all rays of a packet, of a query: at its place in time, and with the contacts of the
// point where the ray starts (geometry/contact.h). Nearest hits and visibility both ask here.

#include "drt/accel/accel.h"
#include "drt/geometry/contact.h"

namespace drt::accel_detail {

// Tolerances. `slack` bounds how far rounding has moved a ray's origin: by its coordinates, and by the length of the
// way that led there. Two hits tie when their surfaces are closer than the slack, what the way to them adds, and the
// errors of the surfaces. A start touches a surface within more than that: whatever tied with the hit that became the
// start touches the start.
template <class Real>
inline constexpr Real origin_error = 4 * std::numeric_limits<Real>::epsilon();

template <class T>
[[gnu::always_inline]] inline T start_tolerance(const T& slack, ScalarOf<T> surface_error) {
    return slack * T(3) + T(4 * surface_error);
}

template <class T>
[[gnu::always_inline]] inline T tie_distance(const T& slack, const T& t, const T& surface_errors) {
    return slack + t * T(travel_error<ScalarOf<T>>) + surface_errors;
}

/// One lane, or all lanes, of a query's rays.
template <class T>
struct Rays {
    using Real = ScalarOf<T>;
    Vec3<T> o, d;
    T tmax;
    Rebind<T, float> time;
    Rebind<T, int> start;
    T slack;                       ///< how far rounding may have moved the origin
    const Departures<Real>* from;  ///< null: free starts
    int number;                    ///< of the (first) ray in the columns of `from`
};

/// On which side of the body the point where a ray starts lies. Of a medium, the path itself knows: it remembers what
/// it has entered, so that a surface which coincides with the start's is crossed once, whichever of the two was met
/// first. Of other bodies, the side from which the path came, for nothing crosses them.
template <class T>
MaskOf<T> started_inside(const ContactRole& role, int body, const MaskOf<T>& came_inside,
                         const Rebind<T, int>& came_from, const Rays<T>& r) {
    using I = Rebind<T, int>;
    const auto& from = *r.from;
    MaskOf<T> inside = came_inside;
    if (role.refracts && role.solid && from.media.counts) {
        const I slot = load<I>(from.slot + r.number);
        if constexpr (is_lane<T>) {
            for (int i = 0; i < width_of<T>; ++i) inside[i] = slot[i] >= 0 && from.media.holds(slot[i], body);
            return inside;
        } else {
            return slot >= 0 && from.media.holds(slot, body);
        }
    }
    // A path that has just left this very body ran on the side to which it left, at however flat an angle.
    const auto from_it = mask_cast<T>(came_from >= I(0) && start::body(came_from) == I(body));
    return (from_it && !mask_cast<T>(start::outward(came_from))) || (!from_it && inside);
}

/// The same as meet_at() where the start touches the body. Rare, and so out of the way: it takes values, and loads the
/// rays itself, so that those of the common case stay in registers.
template <class Lanes, class T, class Shape>
[[gnu::noinline]] ShapeHit<T> meet_touching(Lanes lanes, const Shape& shape, const ContactRole& role, int body,
                                            Vec3<T> o, Vec3<T> d, Vec3<T> arrival_d, T tolerance, MaskOf<T> touch,
                                            Relation<T> rel) {
    using I = Rebind<T, int>;
    const Rays<T> r = lanes.rays();
    const Arrival<T> arrival = arrival_at<T>(*r.from, r.number, largest_coordinate(r.o));
    const Contact<T> c = contact_at(shape, Turning<T>{o, d, arrival_d, arrival.travelled, tolerance});
    const auto inside = started_inside(role, body, c.came_inside, arrival.came_from, r);
    // Nothing gets past the edge of what is opaque: bodies that only touch there let no light through.
    const auto goes_inside = c.goes_inside || (!MaskOf<T>(role.refracts) && !inside && c.clips);
    const auto crosses = touch && inside != goes_inside && r.tmax > T(0);
    const auto touch_i = mask_cast<I>(touch);
    const Relation<T> as_if_on{rel.on || touch, (touch && !goes_inside) || (!touch && rel.outward),
                               select(touch_i, c.part, rel.part)};
    ShapeHit<T> h = intersect(shape, o, d, as_if_on, r.slack, r.tmax);
    h.valid = h.valid || crosses;
    h.t = select(crosses, T(0), h.t);
    h.ng = select(crosses, c.ng, h.ng);
    h.part = select(mask_cast<I>(crosses), c.part, h.part);
    return h;
}

/// `turn` leads from world directions to the shape's; o and d are the shape's already.
template <class Lanes, class T, class Shape, class Turn>
[[gnu::always_inline]] inline ShapeHit<T> meet_at(const BodyTable<ScalarOf<T>>& table, const Shape& shape, int body,
                                                  const Vec3<T>& o, const Vec3<T>& d, const Lanes& lanes,
                                                  const Rays<T>& r, Turn turn) {
    using I = Rebind<T, int>;
    const auto on = r.start >= I(0) && start::body(r.start) == I(body);
    const Relation<T> rel{mask_cast<T>(on), mask_cast<T>(start::outward(r.start)), start::part(r.start)};
    if (r.from) {
        const T tolerance = start_tolerance(r.slack, table.surface_error[size_t(body)]);
        const auto touch = touches(shape, o, tolerance) && mask_cast<T>(r.start >= I(0) && !on);
        if (any(touch)) [[unlikely]] {
            const Vec3<T> arrival = turn(arrival_at<T>(*r.from, r.number, largest_coordinate(r.o)).d);
            return meet_touching(lanes, shape, table.roles[size_t(body)], body, o, d, arrival, tolerance, touch, rel);
        }
    }
    return intersect(shape, o, d, rel, r.slack, r.tmax);
}

}  // namespace drt::accel_detail
