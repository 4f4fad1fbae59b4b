#pragma once
// Mass and inertia of bodies that a simulation can move.

#include <optional>

#include "drt/scene/scene_desc.h"

namespace drt {

/// About the body's centre and its principal axes: those of a box as described; of a cylinder, z is its axis; of a
/// sphere, any.
struct MassProperties {
    double mass = 0;
    Vec3d inertia;  ///< mass * length^2
};

/// Bodies are full of a uniform density. An open cylinder counts as a closed one: its wall has no thickness to have a
/// mass.
/// Empty for shapes that cannot be dynamic: without a volume (plane, triangle, rectangle, parallelogram, disc), or
/// many bodies in one (sphere_set).
std::optional<MassProperties> mass_properties(const Shape&, const PhysicsDesc&);

/// For values outside, products with the scene's other numbers could overflow or vanish.
inline constexpr double least_mass = 1e-30, largest_mass = 1e30;
inline constexpr double least_inertia = 1e-60, largest_inertia = 1e60;

}  // namespace drt
