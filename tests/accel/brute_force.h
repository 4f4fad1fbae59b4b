#pragma once
// Every body against every ray, one ray at a time and without a BVH: the slow version of accel's queries. It shares
// the shapes' arithmetic, which tests/geometry checks.

#include <array>
#include <limits>
#include <vector>

#include "drt/accel/accel.h"
#include "drt/geometry/intersect.h"
#include "geometry/random_paths.h"

namespace drt::test {

template <class Real>
struct OneRay {
    Vec3<Real> o, d;
    Real tmax = std::numeric_limits<Real>::infinity();
    float time = 0;
    int start = start::none;
};

struct OneHit {
    double t = 0;
    int body = no_body, part = 0;
    Vec3d ng;
};

template <class Real, class Shape>
ShapeHit<Real> meet(const BodyTable<Real>& t, int body, const Shape& s, const OneRay<Real>& r) {
    const bool on = r.start >= 0 && start::body(r.start) == body;
    const Relation<Real> rel{on, start::outward(r.start), start::part(r.start)};
    const Real slack =
        4 * std::numeric_limits<Real>::epsilon() * std::max({std::abs(r.o.x), std::abs(r.o.y), std::abs(r.o.z)});
    const auto path = t.path(body);
    if (path.empty()) return intersect(s, r.o - t.centers[size_t(body)], r.d, rel, slack, r.tmax);
    const Pose<Real> pose = pose_at(path, Real(r.time));
    const Quat<Real>& q = pose.orientation;
    ShapeHit<Real> h = intersect(s, rotate_back(q, r.o - pose.center), rotate_back(q, r.d), rel, slack, r.tmax);
    h.ng = rotate(q, h.ng);
    return h;
}

template <class Real>
ShapeHit<Real> meet_body(const BodyTable<Real>& t, int body, const OneRay<Real>& r) {
    const auto shape_index = [&](const BodyGroup& g) { return size_t(g.first_shape + body - g.first); };
    for (const BodyGroup& g : t.groups) {
        if (body < g.first || body >= g.first + g.count) continue;
        const size_t i = shape_index(g);
        if (g.kind == ShapeKind::sphere) return meet(t, body, t.spheres[i], r);
        if (g.kind == ShapeKind::flat) return meet(t, body, t.flats[i], r);
        if (g.kind == ShapeKind::box) return meet(t, body, t.boxes[i], r);
        return meet(t, body, t.cylinders[i], r);
    }
    return meet(t, body, t.planes[size_t(body - t.plane_group.first)], r);
}

/// All hits before tmax.
template <class Real>
std::vector<OneHit> all_hits(const BodyTable<Real>& t, const OneRay<Real>& r) {
    std::vector<OneHit> out;
    for (int body = 0; body < t.body_count(); ++body)
        if (const ShapeHit<Real> h = meet_body(t, body, r); h.valid)
            out.push_back({double(h.t), body, h.part, Vec3d(h.ng)});
    return out;
}

/// How one ray's path came to its start, in the form that accel reads.
template <class Real>
struct OneDeparture {
    static constexpr int width = Pack<Real>::width;
    std::array<Real, width> dx{}, dy{}, dz{}, travelled{};
    std::array<std::int32_t, width> came_from{}, slot{};
    std::vector<std::int32_t> media;  ///< that the path is inside of, the owner last
    std::int32_t media_count = 0;
    Departures<Real> columns;

    OneDeparture(const Vec3<Real>& arrival, Real distance, int from, const std::vector<std::int32_t>& inside)
        : media(inside), media_count(int(inside.size())) {
        dx.fill(arrival.x), dy.fill(arrival.y), dz.fill(arrival.z);
        travelled.fill(distance);
        came_from.fill(from);
        columns = {dx.data(),
                   dy.data(),
                   dz.data(),
                   travelled.data(),
                   came_from.data(),
                   slot.data(),
                   {media.data(), &media_count, 1}};
    }
    OneDeparture(const OneDeparture&) = delete;
    OneDeparture& operator=(const OneDeparture&) = delete;
};

/// One packet through the accelerator. Lanes beyond the given rays are inactive and hold rubbish.
template <class Real>
RayPacket<Real> packet(const std::vector<OneRay<Real>>& rays) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();
    RayPacket<Real> p;
    p.o = p.d = Vec3<typename Pack<Real>::R>(Vec3<Real>{nan, nan, nan});
    p.tmax = nan;
    p.time = std::numeric_limits<float>::quiet_NaN();
    p.start = start::none;
    p.active = typename Pack<Real>::Mask(false);
    for (int i = 0; i < int(rays.size()); ++i) {
        const OneRay<Real>& r = rays[size_t(i)];
        p.o.x[i] = r.o.x, p.o.y[i] = r.o.y, p.o.z[i] = r.o.z;
        p.d.x[i] = r.d.x, p.d.y[i] = r.d.y, p.d.z[i] = r.d.z;
        p.tmax[i] = r.tmax;
        p.time[i] = r.time;
        p.start[i] = r.start;
        p.active[i] = true;
    }
    return p;
}

template <class Real>
OneHit lane_of(const HitPacket<Real>& h, int i) {
    OneHit one;
    one.t = double(lane(h.t, i));
    one.body = lane(h.body, i);
    if (one.body != no_body) {
        one.part = lane(h.part, i);
        one.ng = {double(lane(h.ng.x, i)), double(lane(h.ng.y, i)), double(lane(h.ng.z, i))};
    }
    return one;
}

template <class Real>
std::vector<OneHit> trace(const Accel<Real>& accel, const std::vector<OneRay<Real>>& rays, TraceCounters& counters) {
    HitPacket<Real> h;
    accel.intersect(packet(rays), h, counters);
    std::vector<OneHit> out;
    for (int i = 0; i < int(rays.size()); ++i) out.push_back(lane_of(h, i));
    return out;
}

template <class Real>
OneHit trace(const Accel<Real>& accel, const OneRay<Real>& ray) {
    TraceCounters counters;
    return trace(accel, std::vector{ray}, counters)[0];
}

/// `from` may be null: the ray starts freely.
template <class Real>
OneHit trace(const Accel<Real>& accel, const OneRay<Real>& ray, const OneDeparture<Real>* from) {
    RayPacket<Real> p = packet(std::vector{ray});
    if (from) p.from = &from->columns;
    TraceCounters counters;
    HitPacket<Real> h;
    accel.intersect(p, h, counters);
    return lane_of(h, 0);
}

template <class Real>
bool blocked(const Accel<Real>& accel, const OneRay<Real>& ray, int exclude = -1,
             const OneDeparture<Real>* from = nullptr) {
    RayPacket<Real> p = packet(std::vector{ray});
    if (from) p.from = &from->columns;
    TraceCounters counters;
    return lane_bit(accel.occluded(p, typename Pack<Real>::I(exclude), counters), 0);
}

}  // namespace drt::test
