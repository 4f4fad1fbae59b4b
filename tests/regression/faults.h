#pragma once
// Faults that the comparison with the references must see, each in a scene that shows it.

#include <functional>
#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"

namespace drt {

struct PlantedFault {
    std::string name;  ///< lower case words, joined by underscores
    std::string shot;
    int seeds = 1;  ///< that it takes to be seen reliably
    std::function<void(SceneDesc&)> plant;
};

/// Those that one seed shows: what every run of the comparison sees.
std::vector<PlantedFault> plain_faults();

/// Those that take several seeds, and the lights of all shots.
std::vector<PlantedFault> subtle_faults();

}  // namespace drt
