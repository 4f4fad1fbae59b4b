#pragma once
// Where a body is at a time.

#include "drt/scene/scene_desc.h"

namespace drt::reference {

struct Pose {
    Vec3d position;     ///< of the centre
    Quatd orientation;  ///< turn from the described pose, about the centre
};

/// The pose at scene time `time`; constant before the first and after the last key.
Pose pose_at(const Motion&, double time);

/// The point about which motion turns the shape.
Vec3d center_of(const Shape&);

/// The edge of a rectangle that starts at vertex0 and is perpendicular to vertex0-vertex1.
Vec3d second_edge(const Rectangle&);

}  // namespace drt::reference
