#pragma once

#include <vector>

#include "drt/light/light_bounds.h"

namespace drt {

struct BoundedLight {
    LightBounds bounds;
    LightId id = no_light;
};

/// The lights' order in the vector is changed. The same tree for the same lights, whatever the machine.
LightTree build_light_tree(std::vector<BoundedLight>& lights);

}  // namespace drt
