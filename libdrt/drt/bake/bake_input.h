#pragma once
// What the motion of dynamic bodies depends on, and nothing else: a scene without whatever cannot change it. Baking
// starts from here, so two scenes with the same input have the same motion, and its text is the cache's key.

#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"

namespace drt {

struct BakeInput {
    SceneDesc scene;            ///< bodies with physics, cameras' eyes; everything else as by default
    double begin = 0, end = 0;  ///< scene time that is simulated
    std::vector<int> bodies;    ///< of the whole scene, by body of `scene`
};

/// The scene must have passed validate(). `until`: the latest scene time that is going to be shown; what simulation.end
/// does not limit is simulated at least that far, up to `latest_simulated`.
BakeInput bake_input(const SceneDesc&, double until);

/// Equal inputs, equal text. Holds the version of drt and of the method, too.
std::string input_text(const BakeInput&);

/// Does any body take part in a simulation?
bool has_physics(const SceneDesc&);

/// The latest scene time that is shown by cameras whose video ends; `simulation.start` if there are none.
double latest_shown(const SceneDesc&);

}  // namespace drt
