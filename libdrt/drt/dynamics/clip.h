#pragma once
// Polygons in space: what is left of one beyond a plane, and which of many points to keep.

#include <vector>

#include "drt/dynamics/polytope.h"

namespace drt {

/// What of a polygon, or of a line of two points, is below the plane through `at` with the normal n, of any length
/// (Sutherland and Hodgman 1974). Corners within 1e-9 of the plane are below it.
std::vector<Vec3d> clip(const std::vector<Vec3d>& polygon, const Vec3d& at, const Vec3d& n);

/// At most most_surface_points: the deepest first, and always the one that is farthest from those before it.
std::vector<SurfacePoint> spread(std::vector<SurfacePoint>);

}  // namespace drt
