#pragma once
// SceneDesc shapes -> geometry's shapes, centres and texture mappings, all in double and scene coordinates.

#include <optional>

#include "drt/geometry/body_table.h"
#include "drt/plan/world.h"
#include "drt/scene/scene_desc.h"

namespace drt {

struct BuiltBody {
    AnyShape shape;
    Vec3d center;
    std::optional<Mapping<double>> mapping;  ///< none for shapes that carry no texture
};

BuiltBody build_body(const Shape&);

/// The body turned about its centre, for poses that do not change during the exposure.
BuiltBody turned(BuiltBody, const Quatd&);

/// The body that shows a visible rectangle or sphere light.
BuiltBody build_light_body(const LightShape&);

}  // namespace drt
