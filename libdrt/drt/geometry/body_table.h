#pragma once
// All bodies of a frame as flat arrays, in the order the accelerator wants: bodies of one kind and one number of time
// steps are neighbours, infinite planes come last. A body's id is its index here.

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "drt/geometry/bounds.h"
#include "drt/geometry/intersect.h"
#include "drt/geometry/motion_path.h"
#include "drt/geometry/shapes.h"

namespace drt {

/// Bodies first .. first + count - 1, all of one kind.
struct BodyGroup {
    ShapeKind kind = ShapeKind::sphere;
    bool moving = false;
    int time_steps = 1;  ///< of their bounds; 1 = static bounds
    int first = 0, count = 0;
    int first_shape = 0;  ///< body first + i has shape first_shape + i in its kind's array
};

/// What decides where bodies touch or overlap, the same for every ray.
struct ContactRole {
    /// Among all bodies; the lowest owns an overlap of media (plan/rank.h).
    std::int32_t rank = 0;
    /// Its surface may lead into it: it belongs to the media that a path keeps track of.
    bool refracts = false;
    /// It fills a volume: a closed shape, or what lies behind a plane that refracts. (The table's builder finds it.)
    bool solid = false;
};

struct PieceRange {
    int first = 0, count = 0;  ///< count 0: the body stands still
};

template <class Real>
struct BodyTable {
    std::vector<Vec3<Real>> centers;  ///< of bodies that stand still (moving ones: at u = 0)
    std::vector<PieceRange> motions;  ///< per body; empty when nothing moves
    std::vector<MotionPiece<Real>> pieces;
    std::vector<SphereShape<Real>> spheres;
    std::vector<FlatShape<Real>> flats;
    std::vector<BoxShape<Real>> boxes;
    std::vector<CylinderShape<Real>> cylinders;
    std::vector<PlaneShape<Real>> planes;
    std::vector<ContactRole> roles;   ///< per body
    std::vector<Real> surface_error;  ///< per body: how far rounding may have moved its surface
    std::vector<BodyGroup> groups;    ///< bounded bodies, for the accelerator
    BodyGroup plane_group{ShapeKind::plane, false, 1, 0, 0, 0};

    int body_count() const { return int(centers.size()); }
    std::span<const MotionPiece<Real>> path(int body) const {
        if (motions.empty()) return {};
        const PieceRange r = motions[size_t(body)];
        return {pieces.data() + r.first, size_t(r.count)};
    }
};

using AnyShape =
    std::variant<SphereShape<double>, FlatShape<double>, BoxShape<double>, CylinderShape<double>, PlaneShape<double>>;

/// A body before it is put into the table.
struct BodyInput {
    AnyShape shape;
    Vec3d center;
    std::vector<MotionPiece<double>> path;  ///< empty: it stands still at `center`
    ContactRole role{};
};

/// `order[id]` is the index in `inputs` of the body with that id.
template <class Real>
struct BuiltTable {
    BodyTable<Real> table;
    std::vector<int> order;
};

template <class Real>
BuiltTable<Real> build_body_table(const std::vector<BodyInput>& inputs);

/// Bounds of one body of the table at its group's time steps (one entry for a static group).
template <class Real>
std::vector<Bounds> body_bounds(const BodyTable<Real>&, const BodyGroup&, int body);

/// The shape array of one kind.
template <ShapeKind kind, class Real>
const auto& shapes_of(const BodyTable<Real>& t) {
    if constexpr (kind == ShapeKind::sphere)
        return t.spheres;
    else if constexpr (kind == ShapeKind::flat)
        return t.flats;
    else if constexpr (kind == ShapeKind::box)
        return t.boxes;
    else if constexpr (kind == ShapeKind::cylinder)
        return t.cylinders;
    else
        return t.planes;
}

}  // namespace drt
