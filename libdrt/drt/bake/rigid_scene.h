#pragma once
// SceneDesc -> RigidScene: the bodies that take part in a simulation, in the scene's own scale.

#include "drt/bake/bake_input.h"
#include "drt/dynamics/rigid_body.h"

namespace drt {

/// Rigid coordinates are lengths in units of the smallest dynamic body (sphere: radius; box: smallest half edge;
/// cylinder: the smaller of radius and half height) from the middle of all dynamic bodies, masses in units of the
/// lightest one: so the simulation's thresholds mean the same in any scene, whatever its units.
struct RigidUnits {
    double length = 1, mass = 1;
    Vec3d origin;

    Vec3d from_scene(const Vec3d& position) const { return (position - origin) / length; }
    Vec3d to_scene(const Vec3d& position) const { return origin + position * length; }
};

struct RigidModel {
    RigidScene scene;  ///< bodies as in the input
    RigidUnits units;
    std::vector<Quatd> frames;  ///< by body: a rigid body's own axes as the scene describes it; a motion key turns from
                                ///< there, so its orientation is the rigid state's times the frame's inverse
};

RigidModel build_rigid_scene(const BakeInput&);

/// About which motion turns a body.
Vec3d center_of(const Shape&);

}  // namespace drt
