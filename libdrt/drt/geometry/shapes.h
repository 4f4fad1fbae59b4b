#pragma once
// The shapes a ray can hit, each about its own centre, and the arithmetic of one ray (or one packet) against one of
// them. T is Real or lanes of Real; shape data is the same for all lanes.
//
// A ray that starts ON a shape never relies on an epsilon. The caller says where it starts (Start) and the root that
// belongs to the start is left out by construction, so there are no self-hits and no lost exits (measured: any fixed
// tnear has both, docs/geometry.md).

#include <cstdint>

#include "drt/base/vec.h"

namespace drt {

enum class ShapeKind : std::uint8_t { sphere, flat, box, cylinder, plane };

template <class Real>
struct SphereShape {
    Real radius;
};

enum class Outline : std::uint8_t { parallelogram, triangle, disc };

/// A bounded piece of a plane. A point p has coordinates a = dot(p - origin, da), b = dot(p - origin, db); inside is
/// parallelogram: 0 <= a, b <= 1; triangle: 0 <= a, b and a + b <= 1; disc: a^2 + b^2 <= 1 (origin = centre).
template <class Real>
struct FlatShape {
    Vec3<Real> origin;  ///< relative to the body's centre
    Vec3<Real> normal;  ///< unit
    Vec3<Real> da, db;  ///< dual basis of the edges
    Outline outline;
    Real da_size = 0, db_size = 0;  ///< at least the lengths of da, db: how far a distance leads in a and b
};

/// Rows of the rotation from world to the box' own axes.
template <class Real>
struct BoxShape {
    Vec3<Real> ax, ay, az;  ///< unit
    Vec3<Real> half;        ///< half extents
};

template <class Real>
struct CylinderShape {
    Vec3<Real> ax, ay, az;  ///< unit; az is the axis, ax the zero azimuth
    Real radius, half_height;
    bool capped;
};

template <class Real>
struct PlaneShape {
    Vec3<Real> normal;  ///< unit
};

/// Which part of a shape was hit: box 0..5 = +x -x +y -y +z -z; cylinder 0 side, 1 the cap at +axis, 2 at -axis; else
/// 0.
enum Part : int { part_side = 0, part_top = 1, part_bottom = 2 };

/// Where a ray starts: on which body, which part, and whether it leaves outward (the side that the geometric normal
/// points to). Packed in an int so that lanes carry it; none = a free start.
namespace start {
inline constexpr int none = -1;
template <class I>
[[gnu::always_inline]] inline I pack(const I& body, const I& part, const I& outward) {
    return (body << 4) | (part << 1) | outward;  // shifts: lanes without a hit hold anything, and products may overflow
}
template <class I>
[[gnu::always_inline]] inline I body(const I& s) {
    return s >> 4;
}
template <class I>
[[gnu::always_inline]] inline I part(const I& s) {
    return (s >> 1) & 7;
}
template <class I>
[[gnu::always_inline]] inline auto outward(const I& s) {
    return (s & 1) == I(1);
}
}  // namespace start

/// How the ray relates to the one body at hand.
template <class T>
struct Relation {
    MaskOf<T> on;         ///< it starts on this body
    MaskOf<T> outward;    ///< ... and leaves it outward (only meaningful where `on`)
    Rebind<T, int> part;  ///< ... from this part
};

template <class T>
struct ShapeHit {
    MaskOf<T> valid;
    T t;
    Vec3<T> ng;  ///< outward, NOT normalised for spheres (length = radius), unit otherwise
    Rebind<T, int> part;
};

}  // namespace drt
