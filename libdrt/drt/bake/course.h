#pragma once
// The course of a kinematic body: where rendering shows it is where others meet it.

#include "drt/bake/rigid_scene.h"

namespace drt {

/// Paths of constant acceleration and spin over [begin, end], made from the same pieces that are rendered. Linear
/// motion and turns are exact. Cubic motion is cut into parabolas whose positions and velocities join, so that nothing
/// that lies on the body is struck; they are off by no more than this, in units of the rigid scene, or by rounding.
inline constexpr double course_tolerance = 1e-6;

Track course_of(const Motion&, const RigidUnits&, const Quatd& frame, double begin, double end);

}  // namespace drt
