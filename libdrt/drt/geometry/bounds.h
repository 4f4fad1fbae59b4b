#pragma once
// Axis-aligned bounds, also of moving bodies: Embree interpolates bounds linearly between equally spaced time steps,
// so the bounds of each step are widened by how far the path leaves the chord.

#include <span>
#include <vector>

#include "drt/geometry/motion_path.h"
#include "drt/geometry/shapes.h"

namespace drt {

struct Bounds {
    Vec3d lower{1, 1, 1}, upper{-1, -1, -1};  ///< empty
    bool empty() const { return lower.x > upper.x; }
};

Bounds unite(const Bounds&, const Bounds&);
Bounds around(const Vec3d& center, const Vec3d& half);

/// Half extents of a shape about its centre.
template <class Real>
Vec3d half_extent(const SphereShape<Real>&);
template <class Real>
Vec3d half_extent(const FlatShape<Real>&);
template <class Real>
Vec3d half_extent(const BoxShape<Real>&);
template <class Real>
Vec3d half_extent(const CylinderShape<Real>&);

/// Is the body ever turned out of its described orientation?
bool turns(std::span<const MotionPiece<double>>);

/// The largest distance, per axis, between the path's centre and the chord over [u0, u1]. Exact: each piece is a cubic
/// whose difference to the chord has its extremes at the ends or at the roots of a quadratic.
Vec3d chord_deviation(std::span<const MotionPiece<double>>, double u0, double u1);

/// Bounds at `steps` equally spaced times (steps >= 2) such that linear interpolation between neighbours contains the
/// body at every time. `extent` bounds it about its centre in every orientation that it takes.
std::vector<Bounds> bounds_over_time(std::span<const MotionPiece<double>>, const Vec3d& extent, int steps);

/// How many time steps are worth having: enough that the widening stays below a fifth of the body's size; 2 to 17.
int time_steps_for(std::span<const MotionPiece<double>>, const Vec3d& extent);

}  // namespace drt
