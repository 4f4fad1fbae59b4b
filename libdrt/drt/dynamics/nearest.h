#pragma once
// Where two bodies are nearest, for the pairs of shapes that have a closed form.

#include <optional>

#include "drt/dynamics/rigid_body.h"

namespace drt {

/// Bodies closer than this touch, where distances have closed forms (in units of the scene's scale: rigid_body.h).
inline constexpr double touch_distance = 1e-11;

struct Nearest {
    double distance = 0;            ///< negative: how deep they overlap
    Vec3d normal;                   ///< unit, from the second body towards the first
    Vec3d point;                    ///< on the second body, in the world
    double error = touch_distance;  ///< of the distance: bodies closer than this touch
};

/// Spheres with everything, and everything with planes.
std::optional<Nearest> nearest_in_closed_form(const Collider&, const RigidState&, const Collider&, const RigidState&);

/// Of the body's farthest point from its centre; infinite for planes.
double bounding_radius(const Collider&);
/// The same, but 0 for spheres and planes: how far out are corners that come nearer when the body turns.
double corner_reach(const Collider&);

}  // namespace drt
