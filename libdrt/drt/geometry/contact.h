#pragma once
// Surfaces in contact. A point that a path has reached lies on the surface that it hit, and within rounding on every
// other surface that touches that one there: the floor under a glass, the next wall at a corner of a room, the wall
// itself that rounding has pushed the point through. Where such a surface is met cannot be asked of distances, which
// are rounding. What is certain is on which side of it the path came, and to which side the new ray goes: the ray
// crosses the surface, at distance 0, if these differ, and otherwise leaves from the one side as if it started there.
//
// All in the shape's own centred coordinates, as in intersect.h. "Inside" a flat shape is the side that its normal
// points away from.

#include "drt/geometry/intersect.h"

namespace drt {

/// A point on a surface within tolerance, and the two rays that meet there.
template <class T>
struct Contact {
    MaskOf<T> came_inside;  ///< the arriving ray ran inside the body just before the point
    MaskOf<T> goes_inside;  ///< the leaving ray runs inside it just after
    MaskOf<T> clips;        ///< it goes through a face that the path was in front of, if only to leave again at once
    Vec3<T> ng;             ///< of the face that is crossed if they differ; outward, as ShapeHit's
    Rebind<T, int> part;    ///< the same
};

// ---- which points lie on the surface --------------------------------------------------------------------------------

template <class T>
[[gnu::always_inline]] inline MaskOf<T> touches(const SphereShape<ScalarOf<T>>& s, const Vec3<T>& p,
                                                const T& tolerance) {
    using std::abs;
    const T r(s.radius);
    return abs(dot(p, p) - r * r) < tolerance * (T(2) * r + tolerance);
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> touches(const FlatShape<ScalarOf<T>>& s, const Vec3<T>& p, const T& tolerance) {
    using std::abs;
    const Vec3<T> q = p - Vec3<T>(s.origin);
    const auto in_plane = abs(dot(q, Vec3<T>(s.normal))) < tolerance;
    if (!any(in_plane)) return in_plane;
    return in_plane && inside_outline(s, q, tolerance);
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> touches(const PlaneShape<ScalarOf<T>>& s, const Vec3<T>& p,
                                                const T& tolerance) {
    using std::abs;
    return abs(dot(p, Vec3<T>(s.normal))) < tolerance;
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> touches(const BoxShape<ScalarOf<T>>& s, const Vec3<T>& p, const T& tolerance) {
    using std::abs;
    const T x = abs(dot(p, Vec3<T>(s.ax))) - T(s.half.x);
    const T y = abs(dot(p, Vec3<T>(s.ay))) - T(s.half.y);
    const T z = abs(dot(p, Vec3<T>(s.az))) - T(s.half.z);
    return abs(max(x, max(y, z))) < tolerance;
}

template <class T>
[[gnu::always_inline]] inline MaskOf<T> touches(const CylinderShape<ScalarOf<T>>& s, const Vec3<T>& p,
                                                const T& tolerance) {
    using std::abs;
    using std::sqrt;
    const T x = dot(p, Vec3<T>(s.ax)), y = dot(p, Vec3<T>(s.ay));
    const T beside = sqrt(x * x + y * y) - T(s.radius);
    const T beyond = abs(dot(p, Vec3<T>(s.az))) - T(s.half_height);
    if (!s.capped) return abs(beside) < tolerance && beyond < tolerance;
    return abs(max(beside, beyond)) < tolerance;
}

// ---- sides ----------------------------------------------------------------------------------------------------------

/// How a path came to a point of a surface, and how it goes on. In the shape's coordinates; directions of unit length.
template <class T>
struct Turning {
    Vec3<T> p, d;     ///< the point, and the direction in which the path goes on
    Vec3<T> arrival;  ///< the direction in which it came
    T travelled;      ///< the way that it came
    T tolerance;      ///< the point is on the surface within this
};

/// Whether the path came from behind the face with this unit normal, from which the point is `height` away. A way that
/// lies within rounding of the face all along does not tell: then the height does, whatever it is worth.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> came_from_behind(const Turning<T>& at, const Vec3<T>& n, const T& height) {
    using std::abs;
    const T rise = dot(at.arrival, n);
    const auto tells = abs(rise) * at.travelled > T(2) * at.tolerance;
    return (tells && rise > T(0)) || (!tells && height < T(0));
}

/// The faces of a convex body that a point lies on, one after another. A ray is inside just after (or was just before)
/// the point if it is behind all of them.
template <class T>
class FacesAt {
public:
    explicit FacesAt(const Turning<T>& at) : at_(at) {}

    void add(const Vec3<T>& n, const T& height, const Rebind<T, int>& part) {
        using std::abs;
        const auto on_it = abs(height) < at_.tolerance;
        const auto behind = came_from_behind(at_, n, height);
        const T up = dot(at_.d, n);
        came_inside_ = came_inside_ && (!on_it || behind);
        goes_inside_ = goes_inside_ && (!on_it || up < T(0));
        clips_ = clips_ || (on_it && !behind && up < T(0));
        const T descent = up + select(behind, T(2), T(0));  // a face that the path was behind of is not its entry
        entry_.take(on_it && descent < entry_.up, descent, n, part);
        exit_.take(on_it && up >= exit_.up, up, n, part);
    }

    Contact<T> contact() const {
        const auto enters = goes_inside_ || (!came_inside_ && clips_);
        return {came_inside_, goes_inside_, clips_, select(enters, entry_.n, exit_.n),
                select(mask_cast<Rebind<T, int>>(enters), entry_.part, exit_.part)};
    }

private:
    struct Face {
        T up;
        Vec3<T> n;
        Rebind<T, int> part{0};
        void take(const MaskOf<T>& m, const T& new_up, const Vec3<T>& new_n, const Rebind<T, int>& new_part) {
            up = select(m, new_up, up);
            n = select(m, new_n, n);
            part = select(mask_cast<Rebind<T, int>>(m), new_part, part);
        }
    };
    Turning<T> at_;
    MaskOf<T> came_inside_{true}, goes_inside_{true}, clips_{false};
    Face entry_{T(4), {}, {}}, exit_{T(-2), {}, {}};  // the steepest crossings
};

template <class T>
Contact<T> one_face(const MaskOf<T>& behind, const Vec3<T>& d, const Vec3<T>& n) {
    const auto goes_inside = dot(d, n) < T(0);
    return {behind, goes_inside, goes_inside, n, Rebind<T, int>(0)};
}

template <class T>
Contact<T> contact_at(const SphereShape<ScalarOf<T>>& s, const Turning<T>& at) {
    const T r(s.radius);
    const T height = (dot(at.p, at.p) - r * r) / (T(2) * r);
    return one_face(came_from_behind(at, at.p * (T(1) / r), height), at.d, at.p);
}

template <class T>
Contact<T> contact_at(const FlatShape<ScalarOf<T>>& s, const Turning<T>& at) {
    const Vec3<T> n(s.normal);
    const T height = dot(at.p - Vec3<T>(s.origin), n);
    return one_face(came_from_behind(at, n, height), at.d, n);
}

template <class T>
Contact<T> contact_at(const PlaneShape<ScalarOf<T>>& s, const Turning<T>& at) {
    const Vec3<T> n(s.normal);
    return one_face(came_from_behind(at, n, T(dot(at.p, n))), at.d, n);
}

template <class T>
Contact<T> contact_at(const BoxShape<ScalarOf<T>>& s, const Turning<T>& at) {
    FacesAt<T> faces(at);
    const auto axis = [&](const Vec3<ScalarOf<T>>& a, ScalarOf<T> half, int number) {
        const Vec3<T> n(a);
        const T x = dot(at.p, n);
        faces.add(n, x - T(half), Rebind<T, int>(2 * number));
        faces.add(-n, -x - T(half), Rebind<T, int>(2 * number + 1));
    };
    axis(s.ax, s.half.x, 0);
    axis(s.ay, s.half.y, 1);
    axis(s.az, s.half.z, 2);
    return faces.contact();
}

template <class T>
Contact<T> contact_at(const CylinderShape<ScalarOf<T>>& s, const Turning<T>& at) {
    using I = Rebind<T, int>;
    using std::sqrt;
    const Vec3<T> ax(s.ax), ay(s.ay), az(s.az);
    const T x = dot(at.p, ax), y = dot(at.p, ay), z = dot(at.p, az), r(s.radius), h(s.half_height);
    FacesAt<T> faces(at);
    faces.add((ax * x + ay * y) * (T(1) / r), sqrt(x * x + y * y) - r, I(part_side));
    if (s.capped) {
        faces.add(az, z - h, I(part_top));
        faces.add(-az, -z - h, I(part_bottom));
    }
    return faces.contact();
}

// ---- inside ---------------------------------------------------------------------------------------------------------

/// Whether a point is inside a solid, or behind a plane.
template <class T>
MaskOf<T> is_inside(const SphereShape<ScalarOf<T>>& s, const Vec3<T>& p) {
    return dot(p, p) <= T(s.radius * s.radius);
}

template <class T>
MaskOf<T> is_inside(const PlaneShape<ScalarOf<T>>& s, const Vec3<T>& p) {
    return dot(p, Vec3<T>(s.normal)) <= T(0);
}

template <class T>
MaskOf<T> is_inside(const BoxShape<ScalarOf<T>>& s, const Vec3<T>& p) {
    using std::abs;
    return abs(dot(p, Vec3<T>(s.ax))) <= T(s.half.x) && abs(dot(p, Vec3<T>(s.ay))) <= T(s.half.y) &&
           abs(dot(p, Vec3<T>(s.az))) <= T(s.half.z);
}

template <class T>
MaskOf<T> is_inside(const CylinderShape<ScalarOf<T>>& s, const Vec3<T>& p) {
    using std::abs;
    const T x = dot(p, Vec3<T>(s.ax)), y = dot(p, Vec3<T>(s.ay));
    return x * x + y * y <= T(s.radius * s.radius) && abs(dot(p, Vec3<T>(s.az))) <= T(s.half_height);
}

}  // namespace drt
