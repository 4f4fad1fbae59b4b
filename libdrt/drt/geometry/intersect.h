#pragma once
// Ray against shape, in the shape's own centred coordinates: o and d relative to the body's centre, d a unit vector
// (so t is a length). Hits lie in (0, tmax), except that the own second root of a ray that starts on the shape is taken
// whatever its size.
//
// `slack` is how far rounding may have moved the ray where it starts. Flat pieces, boxes and open cylinders are that
// much larger, and what rounding adds on the way: a ray at the common edge of two of them meets one of them, so that
// walls which only touch keep a room dark.

#include "drt/geometry/shapes.h"

// always_inline: see base/simd.h; a call passes every lane through memory.

namespace drt {

/// How far rounding may move a ray along its way, relative to its length.
template <class Real>
inline constexpr Real travel_error = 4 * std::numeric_limits<Real>::epsilon();

/// Nearest root in range of a convex body whose surface is crossed at t_in <= t_out. `t_out_own` replaces t_out for
/// rays that start on it and go inward; rays that start on it and go outward hit nothing.
template <class T>
struct ConvexRoots {
    T t_in, t_out;
    MaskOf<T> crosses;
};

template <class T>
struct Chosen {
    MaskOf<T> valid;
    MaskOf<T> entering;
    T t;
};

template <class T>
[[gnu::always_inline]] inline Chosen<T> choose_root(const ConvexRoots<T>& r, const Relation<T>& rel, const T& tmax) {
    const auto first = r.t_in > T(0) && !rel.on;
    T t = select(first, r.t_in, r.t_out);
    const auto beyond_start = (rel.on && !rel.outward) || (!rel.on && t > T(0));
    t = max(t, T(0));  // an own exit may round to just below zero at a grazing edge: it is still an exit
    return {r.crosses && beyond_start && t < tmax, first, t};
}

/// With the closest approach p = o - (o.d) d and discriminant r^2 - p.p: stable for far and for huge spheres alike
/// (Haines et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems ch. 7).
template <class T>
[[gnu::always_inline]] inline ShapeHit<T> intersect(const SphereShape<ScalarOf<T>>& s, const Vec3<T>& o,
                                                    const Vec3<T>& d, const Relation<T>& rel, const T&, const T& tmax) {
    using std::sqrt;
    const T b = dot(o, d);
    const Vec3<T> p = o - d * b;
    const T r2(s.radius * s.radius);
    const T disc = r2 - dot(p, p);
    const T root = sqrt(max(disc, T(0)));
    // q has the larger magnitude; the other root follows from the product c = o.o - r^2 without cancellation
    const T c = dot(o, o) - r2;
    const T q = select(b > T(0), -b - root, -b + root);
    const T other = select(q == T(0), T(0), c * reciprocal(q));
    ConvexRoots<T> roots{min(q, other), max(q, other), disc >= T(0)};
    roots.t_out = select(rel.on, T(-2) * b, roots.t_out);  // c = 0 exactly on the surface
    roots.crosses = roots.crosses || rel.on;
    const Chosen<T> hit = choose_root(roots, rel, tmax);
    return {hit.valid, hit.t, o + d * hit.t, Rebind<T, int>(0)};
}

/// Whether a point of the plane, relative to the shape's origin, lies on the piece or not farther than `margin` from
/// it.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> inside_outline(const FlatShape<ScalarOf<T>>& s, const Vec3<T>& q,
                                                       const T& margin) {
    using std::abs;
    const T a = dot(q, Vec3<T>(s.da)), b = dot(q, Vec3<T>(s.db));
    const T ma = margin * T(s.da_size), mb = margin * T(s.db_size);
    switch (s.outline) {
        case Outline::parallelogram:
            return abs(a - T(0.5f)) <= T(0.5f) + ma && abs(b - T(0.5f)) <= T(0.5f) + mb;
        case Outline::triangle:
            return a >= -ma && b >= -mb && a + b <= T(1) + (ma + mb);
        case Outline::disc:
            break;
    }
    return a * a + b * b <= T(1) + T(2) * ma;
}

template <class T>
[[gnu::always_inline]] inline ShapeHit<T> intersect(const FlatShape<ScalarOf<T>>& s, const Vec3<T>& o, const Vec3<T>& d,
                                                    const Relation<T>& rel, const T& slack, const T& tmax) {
    const Vec3<T> n(s.normal), q = o - Vec3<T>(s.origin);
    const T t = -dot(q, n) / dot(d, n);  // parallel: inf or NaN, both fail the range test
    const auto in_range = t > T(0) && t < tmax && !rel.on;
    const T margin = slack + t * T(travel_error<ScalarOf<T>>);
    return {in_range && inside_outline(s, q + d * t, margin), t, n, Rebind<T, int>(0)};
}

template <class T>
[[gnu::always_inline]] inline ShapeHit<T> intersect(const PlaneShape<ScalarOf<T>>& s, const Vec3<T>& o,
                                                    const Vec3<T>& d, const Relation<T>& rel, const T&, const T& tmax) {
    const Vec3<T> n(s.normal);
    const T t = -dot(o, n) / dot(d, n);
    return {t > T(0) && t < tmax && !rel.on, t, {n.x, n.y, n.z}, Rebind<T, int>(0)};
}

/// The slab test, one axis after another. Faces are closed: a ray that runs along a face, exactly in it, is inside.
template <class T>
struct Slab {
    static constexpr ScalarOf<T> infinity = std::numeric_limits<ScalarOf<T>>::infinity();
    T lo{-infinity}, hi{infinity};
    Rebind<T, int> lo_axis{0}, hi_axis{0};

    [[gnu::always_inline]] void clip(const T& o, const T& d, ScalarOf<T> half, int axis) {
        using I = Rebind<T, int>;
        using std::abs;
        const T inv = reciprocal(d);
        const T a = (T(-half) - o) * inv, b = (T(half) - o) * inv;
        T near = min(a, b), far = max(a, b);
        // also where the reciprocal would leave the range of numbers
        const auto parallel = abs(d) < T(8 * std::numeric_limits<ScalarOf<T>>::min());
        if (any(parallel)) [[unlikely]] {
            const T apart = select(abs(o) <= T(half), T(-infinity), T(infinity));
            near = select(parallel, apart, near);
            far = select(parallel, -apart, far);
        }
        const auto later = near > lo;
        const auto sooner = far < hi;
        lo = select(later, near, lo);
        hi = select(sooner, far, hi);
        lo_axis = select(mask_cast<I>(later), I(axis), lo_axis);
        hi_axis = select(mask_cast<I>(sooner), I(axis), hi_axis);
    }
};

template <class T>
[[gnu::always_inline]] inline ShapeHit<T> intersect(const BoxShape<ScalarOf<T>>& s, const Vec3<T>& o, const Vec3<T>& d,
                                                    const Relation<T>& rel, const T& slack, const T& tmax) {
    using I = Rebind<T, int>;
    using std::abs;
    const Vec3<T> ax(s.ax), ay(s.ay), az(s.az);
    const Vec3<T> lo{dot(o, ax), dot(o, ay), dot(o, az)}, ld{dot(d, ax), dot(d, ay), dot(d, az)};
    Slab<T> slab;
    slab.clip(lo.x, ld.x, s.half.x, 0);
    slab.clip(lo.y, ld.y, s.half.y, 1);
    slab.clip(lo.z, ld.z, s.half.z, 2);
    // past an edge, the slabs are apart by at least the distance from it
    const T margin = slack + abs(slab.lo) * T(travel_error<ScalarOf<T>>);
    const ConvexRoots<T> roots{slab.lo, slab.hi, slab.lo <= slab.hi + margin || rel.on};
    const Chosen<T> hit = choose_root(roots, rel, tmax);
    const I axis = select(mask_cast<I>(hit.entering), slab.lo_axis, slab.hi_axis);
    const auto is_x = mask_cast<T>(axis == I(0)), is_y = mask_cast<T>(axis == I(1));
    const T component = select(is_x, ld.x, select(is_y, ld.y, ld.z));
    // entering: the face that opposes the direction; leaving: the face along it
    const auto positive = (component > T(0)) != hit.entering;
    const T sign = select(positive, T(1), T(-1));
    const Vec3<T> n = select(is_x, ax, select(is_y, ay, az)) * sign;
    return {hit.valid, hit.t, n, axis * 2 + select(mask_cast<I>(positive), I(0), I(1))};
}

template <class T>
[[gnu::always_inline]] inline ShapeHit<T> intersect(const CylinderShape<ScalarOf<T>>& s, const Vec3<T>& o,
                                                    const Vec3<T>& d, const Relation<T>& rel, const T& slack,
                                                    const T& tmax) {
    using I = Rebind<T, int>;
    using std::abs;
    using std::sqrt;
    const Vec3<T> ax(s.ax), ay(s.ay), az(s.az);
    const T ox = dot(o, ax), oy = dot(o, ay), oz = dot(o, az);
    const T dx = dot(d, ax), dy = dot(d, ay), dz = dot(d, az);
    // infinite tube: the sphere's stable form in the plane across the axis, with unnormalised direction
    const T a = dx * dx + dy * dy;
    const T b = ox * dx + oy * dy;
    const T k = b / a;
    const T px = ox - dx * k, py = oy - dy * k;
    const T r(s.radius);
    const T disc = r * r - (px * px + py * py);
    const T root = sqrt(max(disc, T(0)) * a);
    const T len = sqrt(ox * ox + oy * oy);
    const T c = (len - r) * (len + r);
    const T q = select(b > T(0), -b - root, -b + root);
    const T t0 = q / a, t1 = c / q;
    const auto on_side = rel.on && mask_cast<T>(rel.part == I(part_side));
    const auto along = a <= T(std::numeric_limits<ScalarOf<T>>::min());  // parallel to the axis
    T in = select(along, T(-std::numeric_limits<ScalarOf<T>>::infinity()), min(t0, t1));
    T out = select(along, T(std::numeric_limits<ScalarOf<T>>::infinity()), max(t0, t1));
    in = select(on_side, min(T(0), T(-2) * k), in);
    out = select(on_side, max(T(0), T(-2) * k), out);
    const auto in_tube = select(along, T(c), T(-disc)) <= T(0) || on_side;
    const T h(s.half_height);

    if (!s.capped) {  // a surface, not a solid: each root counts on its own, where it lies between the ends
        const auto between = [&](const T& t) {
            const T z = oz + dz * t;
            return abs(z) <= h + (slack + t * T(travel_error<ScalarOf<T>>));
        };
        const auto use_in = in_tube && !along && !on_side && in > T(0) && in < tmax && between(in);
        const auto own_exit = on_side && !rel.outward;
        const auto use_out = in_tube && !along && (own_exit || (!on_side && out > T(0))) && out < tmax && between(out);
        const T t = select(use_in, in, out);
        const Vec3<T> n = (ax * (ox + dx * t) + ay * (oy + dy * t)) * (T(1) / r);
        return {use_in || use_out, t, n, I(part_side)};
    }

    Slab<T> caps;
    caps.clip(oz, dz, s.half_height, 2);
    const T z_in = caps.lo, z_out = caps.hi;
    const auto side_in = in > z_in, side_out = out < z_out;
    const ConvexRoots<T> roots{select(side_in, in, z_in), select(side_out, out, z_out),
                               (in_tube && max(in, z_in) <= min(out, z_out)) || rel.on};
    const Chosen<T> hit = choose_root(roots, rel, tmax);
    const auto side = (hit.entering && side_in) || (!hit.entering && side_out);
    const auto upward = (dz > T(0)) != hit.entering;
    const T cap_sign = select(upward, T(1), T(-1));
    const Vec3<T> radial = (ax * (ox + dx * hit.t) + ay * (oy + dy * hit.t)) * (T(1) / r);
    const Vec3<T> n = select(side, radial, az * cap_sign);
    const I cap = select(mask_cast<I>(upward), I(part_top), I(part_bottom));
    return {hit.valid, hit.t, n, select(mask_cast<I>(side), I(part_side), cap)};
}

}  // namespace drt
