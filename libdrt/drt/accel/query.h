#pragma once
// The true rays of a query against one body: what nearest hits and visibility do with a candidate, whether Embree has
// found it or it is an infinite plane.

#include "drt/accel/meet.h"
#include "drt/accel/order.h"

namespace drt::accel_detail {

template <class Real>
struct Group {
    const BodyTable<Real>* table = nullptr;
    BodyGroup group;
};

// The rays in Real, and where hits go.
template <class Real>
struct Query {
    using R = typename Pack<Real>::R;
    const RayPacket<Real>* rays = nullptr;
    HitPacket<Real>* hits = nullptr;
    R slack;      // of the rays' origins
    R hit_error;  // of the surfaces hit so far
    typename Pack<Real>::I exclude;
};

// A ray that leaves a convex body outward, or a flat one to either side, never meets it again, and most rays that a
// body's bounds let through are of this kind: those towards the lights from the body that they light.
template <ShapeKind kind, class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask may_hit(const Query<Real>& q, int body) {
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    if constexpr (kind == ShapeKind::cylinder) return typename Pack<Real>::Mask(true);  // an open one is met again
    const I start = q.rays->start;
    const auto on_it = start >= I(0) && start::body(start) == I(body);
    if constexpr (kind == ShapeKind::flat) return !mask_cast<F>(on_it);
    return !mask_cast<F>(on_it && start::outward(start));
}

template <class Real>
Vec3<Real> one_of(const Vec3<typename Pack<Real>::R>& v, int i) {
    return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}

// Which of a query's rays meet a body: all of its lanes, or one.
template <class Real>
struct AllLanes {
    using T = typename Pack<Real>::R;
    const Query<Real>& q;
    [[gnu::always_inline]] Rays<T> rays() const {
        const RayPacket<Real>& r = *q.rays;
        // Number by number: GCC 12 leaves copies of whole vectors in memory.
        return {{r.o.x, r.o.y, r.o.z}, {r.d.x, r.d.y, r.d.z}, r.tmax, r.time, r.start, q.slack, r.from, r.number};
    }
};

template <class Real>
struct OneLane {
    using T = Real;
    const Query<Real>& q;
    int i;
    [[gnu::always_inline]] Rays<T> rays() const {
        const RayPacket<Real>& r = *q.rays;
        return {one_of<Real>(r.o, i), one_of<Real>(r.d, i), lane(r.tmax, i), lane(r.time, i),
                lane(r.start, i),     lane(q.slack, i),     r.from,          r.number + i};
    }
};

template <ShapeKind kind, bool moving, class Real, class Lanes, class T = typename Lanes::T>
[[gnu::always_inline]] inline ShapeHit<T> hit_body(const BodyTable<Real>& table, const BodyGroup& g, int body,
                                                   const Lanes& lanes) {
    const Rays<T> r = lanes.rays();
    const auto& shape = shapes_of<kind>(table)[size_t(g.first_shape + body - g.first)];
    const auto as_it_is = [](const Vec3<T>& v) { return v; };
    if constexpr (!moving) {
        return meet_at(table, shape, body, r.o - Vec3<T>(table.centers[size_t(body)]), r.d, lanes, r, as_it_is);
    } else {
        const T u = num_cast<T>(r.time);
        const auto path = table.path(body);
        if constexpr (kind == ShapeKind::sphere) {
            return meet_at(table, shape, body, r.o - center_at(path, u), r.d, lanes, r, as_it_is);
        } else {
            const Pose<T> pose = pose_at(path, u);
            const Quat<T>& q = pose.orientation;
            const auto turn_back = [&](const Vec3<T>& v) { return rotate_back(q, v); };
            ShapeHit<T> h =
                meet_at(table, shape, body, turn_back(r.o - pose.center), turn_back(r.d), lanes, r, turn_back);
            h.ng = rotate(q, h.ng);
            return h;
        }
    }
}

// How long the normals of a shape's hits are.
template <ShapeKind kind, class Real>
Real normal_length(const BodyTable<Real>& table, const BodyGroup& g, int body) {
    if constexpr (kind == ShapeKind::sphere) return table.spheres[size_t(g.first_shape + body - g.first)].radius;
    return 1;
}

// ---- nearest hit -------------------------------------------------------------------------------------------------

// Of lane i: whether the hit comes before the one that the query holds.
template <class Real>
bool wins_tie(const BodyTable<Real>& table, const Query<Real>& q, int body, const Real& t, const Vec3<Real>& ng,
              int i) {
    const int other = lane(q.hits->body, i);
    if (other == no_body) return true;  // it only ties with the end of the ray
    return is_met_first<Real>({t, ng, table.roles[size_t(body)]},
                              {lane(q.hits->t, i), one_of<Real>(q.hits->ng, i), table.roles[size_t(other)]},
                              one_of<Real>(q.rays->d, i));
}

// Out of the way and with values, as meet_touching().
template <class Real, class R = typename Pack<Real>::R>
[[gnu::noinline]] MaskOf<R> settle_ties(const BodyTable<Real>& table, const Query<Real>& q, int body, R t, Vec3<R> ng,
                                        MaskOf<R> nearer, MaskOf<R> tied) {
    for (int i = 0; i < width_of<R>; ++i)
        if (tied[i]) nearer[i] = wins_tie(table, q, body, lane(t, i), one_of<Real>(ng, i), i);
    return nearer;
}

// Which lanes' hits are nearer than those that the query holds.
template <class Real>
[[gnu::always_inline]] inline MaskOf<typename Pack<Real>::R> is_nearer(const BodyTable<Real>& table,
                                                                       const Query<Real>& q, int body,
                                                                       Real length_of_normal,
                                                                       const ShapeHit<typename Pack<Real>::R>& s,
                                                                       const MaskOf<typename Pack<Real>::R>& valid) {
    using R = typename Pack<Real>::R;
    using std::abs;
    if (!any(mask_cast<R>(q.hits->body >= typename Pack<Real>::I(0)) && valid)) return valid;
    const R gap = s.t - q.hits->t;  // -infinity where nothing has been hit yet
    const R width = tie_distance(q.slack, s.t, q.hit_error + R(table.surface_error[size_t(body)]));
    auto nearer = valid && gap < R(0);
    const auto tied = valid && abs(gap) * abs(dot(q.rays->d, s.ng)) < width * R(length_of_normal);
    if (any(tied)) [[unlikely]]
        nearer = settle_ties(table, q, body, s.t, s.ng, nearer, tied);
    return nearer;
}

template <ShapeKind kind, bool moving, class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask nearest_in_lanes(const Group<Real>& g, int body, Query<Real>& q,
                                                                         const typename Pack<Real>::Mask& valid) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    HitPacket<Real>& h = *q.hits;
    const BodyTable<Real>& table = *g.table;
    const ShapeHit<R> s = hit_body<kind, moving>(table, g.group, body, AllLanes<Real>{q});
    const auto take =
        is_nearer(table, q, body, normal_length<kind>(table, g.group, body), s, s.valid && mask_cast<R>(valid));
    const auto take_i = mask_cast<I>(take);
    h.t = select(take, s.t, h.t);
    h.ng = select(take, s.ng, h.ng);
    h.body = select(take_i, I(body), h.body);
    h.part = select(take_i, s.part, h.part);
    q.hit_error = select(take, R(table.surface_error[size_t(body)]), q.hit_error);
    return mask_cast<F>(take);
}

template <ShapeKind kind, bool moving, class Real>
bool nearest_in_lane(const Group<Real>& g, int body, Query<Real>& q, int i) {
    HitPacket<Real>& h = *q.hits;
    const BodyTable<Real>& table = *g.table;
    const ShapeHit<Real> s = hit_body<kind, moving>(table, g.group, body, OneLane<Real>{q, i});
    if (!s.valid) return false;
    const Real gap = s.t - lane(h.t, i), error = table.surface_error[size_t(body)];
    const Real width = tie_distance(lane(q.slack, i), s.t, lane(q.hit_error, i) + error);
    const bool tied = std::abs(gap) * std::abs(dot(one_of<Real>(q.rays->d, i), s.ng)) <
                      width * normal_length<kind>(table, g.group, body);
    if (!(tied ? wins_tie(table, q, body, s.t, s.ng, i) : gap < 0)) return false;
    h.t[i] = s.t;
    h.ng.x[i] = s.ng.x;
    h.ng.y[i] = s.ng.y;
    h.ng.z[i] = s.ng.z;
    h.body[i] = body;
    h.part[i] = s.part;
    q.hit_error[i] = error;
    return true;
}

// ---- visibility --------------------------------------------------------------------------------------------------

// Where a medium owns the place that a ray leaves from, surfaces of those that it outranks do not exist; and the ray
// cannot leave it without being blocked by its own.
template <class Real>
bool exists_at_start(const BodyTable<Real>& table, const Query<Real>& q, int body, int i) {
    const Departures<Real>* from = q.rays->from;
    if (!from || !from->media.counts) return true;
    const int slot = from->slot[q.rays->number + i];
    const int owner = slot < 0 ? no_body : from->media.owner(slot);
    return owner == no_body || table.roles[size_t(owner)].rank >= table.roles[size_t(body)].rank;
}

// The hit is not at the end of the ray: what the light touches does not hide it.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> before_end(const ShapeHit<T>& s, const Rays<T>& r, ScalarOf<T> surface_error,
                                                   ScalarOf<T> length_of_normal) {
    using std::abs;
    return (r.tmax - s.t) * abs(dot(r.d, s.ng)) >=
           tie_distance(r.slack, r.tmax, T(surface_error)) * T(length_of_normal);
}

template <ShapeKind kind, bool moving, class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask blocked_lanes(const Group<Real>& g, int body,
                                                                      const Query<Real>& q) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    const BodyTable<Real>& table = *g.table;
    const ShapeHit<R> s = hit_body<kind, moving>(table, g.group, body, AllLanes<Real>{q});
    const auto hit = s.valid && mask_cast<R>(q.exclude != I(body));
    if (!any(hit)) return typename Pack<Real>::Mask(false);
    auto blocked = mask_cast<F>(hit && before_end(s, AllLanes<Real>{q}.rays(), table.surface_error[size_t(body)],
                                                  normal_length<kind>(table, g.group, body)));
    if (table.roles[size_t(body)].refracts)
        for (int i = 0; i < width_of<R>; ++i)
            if (blocked[i]) blocked[i] = exists_at_start(table, q, body, i);
    return blocked;
}

template <ShapeKind kind, bool moving, class Real>
bool blocked_lane(const Group<Real>& g, int body, const Query<Real>& q, int i) {
    if (lane(q.exclude, i) == body) return false;
    const BodyTable<Real>& table = *g.table;
    const ShapeHit<Real> s = hit_body<kind, moving>(table, g.group, body, OneLane<Real>{q, i});
    return s.valid &&
           before_end(s, OneLane<Real>{q, i}.rays(), table.surface_error[size_t(body)],
                      normal_length<kind>(table, g.group, body)) &&
           (!table.roles[size_t(body)].refracts || exists_at_start(table, q, body, i));
}

// ---- infinite planes ---------------------------------------------------------------------------------------------
// In functions of their own, moving ones apart: what a scene or a packet does not meet shall not cost it registers.

template <bool moving, class Real>
[[gnu::noinline]] void intersect_plane(const Group<Real>& planes, int body, Query<Real>& q,
                                       typename Pack<Real>::Mask candidates) {
    nearest_in_lanes<ShapeKind::plane, moving>(planes, body, q, candidates);
}

template <bool moving, class Real>
[[gnu::noinline]] typename Pack<Real>::Mask occluded_by_plane(const Group<Real>& planes, int body,
                                                              const Query<Real>& q) {
    return blocked_lanes<ShapeKind::plane, moving>(planes, body, q);
}

template <class Real>
[[gnu::noinline]] void intersect_planes(const Group<Real>& planes, Query<Real>& q, typename Pack<Real>::Mask active) {
    for (int body = planes.group.first; body < planes.group.first + planes.group.count; ++body) {
        const auto candidates = active && may_hit<ShapeKind::plane>(q, body);
        if (!any(candidates)) continue;
        const bool moves = !planes.table->path(body).empty();
        (moves ? intersect_plane<true, Real> : intersect_plane<false, Real>)(planes, body, q, candidates);
    }
}

template <class Real>
[[gnu::noinline]] typename Pack<Real>::Mask occluded_by_planes(const Group<Real>& planes, const Query<Real>& q,
                                                               typename Pack<Real>::Mask active) {
    typename Pack<Real>::Mask blocked(false);
    for (int body = planes.group.first; body < planes.group.first + planes.group.count; ++body) {
        const auto candidates = active && !blocked && may_hit<ShapeKind::plane>(q, body);
        if (!any(candidates)) continue;
        const bool moves = !planes.table->path(body).empty();
        const auto here = (moves ? occluded_by_plane<true, Real> : occluded_by_plane<false, Real>)(planes, body, q);
        blocked = blocked || (candidates && here);
    }
    return blocked;
}

}  // namespace drt::accel_detail
