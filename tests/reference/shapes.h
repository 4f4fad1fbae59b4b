#pragma once
// Rays against shapes in their described pose, and texture coordinates on them.

#include <limits>
#include <optional>

#include "drt/scene/scene_desc.h"

namespace drt::reference {

struct Ray {
    Vec3d origin, direction;  ///< direction is a unit vector
};

struct ShapeHit {
    double distance = 0;
    /// Unit geometric normal. Plane, disc: as given; triangle: cross(v1 - v0, v2 - v0); rectangle, parallelogram:
    /// cross(edge0, edge1); closed bodies outward; open cylinder away from the axis.
    Vec3d normal;
};

/// The nearest hit farther along the ray than `min_distance`.
std::optional<ShapeHit> intersect(const Shape&, const Ray&, double min_distance);

/// Texture coordinates at a point of the surface; v = 0 is the image's top row.
/// Throws std::invalid_argument for shapes that carry no texture.
Vec2d texture_coordinates(const Shape&, const Vec3d& point, const Vec3d& normal, double scale_u, double scale_v);

}  // namespace drt::reference
