#pragma once
// Which of two hits at the same distance is met first. Surfaces that coincide are in contact, and contact is an overlap
// by an infinitesimal: every solid is grown, so entering one comes before leaving another, and the one of lower rank,
// which owns the overlap, is entered first and left last. What is flat lies on top of whatever it touches, seen from
// either side, as a label does. So the order depends on neither rounding nor the order in which the BVH is walked.

#include "drt/accel/accel.h"

namespace drt::accel_detail {

/// One of two hits that are compared. `ng` need not be of unit length.
template <class Real>
struct TiedHit {
    Real t;
    Vec3<Real> ng;
    ContactRole role;
};

/// Surfaces closer in angle than 0.6 degrees coincide where they are closer than rounding; others only cross there.
template <class Real>
bool parallel(const Vec3<Real>& a, const Vec3<Real>& b) {
    const Real ab = dot(a, b);
    return ab * ab > Real(0.9999) * dot(a, a) * dot(b, b);
}

/// Ascending along the ray. What is opaque is left before what refracts: it lies against its outside.
template <class Real>
std::int64_t contact_order(const TiedHit<Real>& h, const Vec3<Real>& d) {
    constexpr std::int64_t stage = std::int64_t{1} << 33;
    if (!h.role.solid) return h.role.rank;
    if (dot(d, h.ng) < 0) return stage + h.role.rank;
    return (h.role.refracts ? 4 : 3) * stage - h.role.rank;
}

template <class Real>
bool is_met_first(const TiedHit<Real>& a, const TiedHit<Real>& b, const Vec3<Real>& d) {
    if (parallel(a.ng, b.ng)) return contact_order(a, d) < contact_order(b, d);
    return a.t < b.t || (a.t == b.t && a.role.rank < b.role.rank);
}

}  // namespace drt::accel_detail
