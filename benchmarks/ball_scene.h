#pragma once
// The yardstick scene of the project's measurements: 16 balls in a rack on a table, two area lights, 640x480.

#include "drt/scene/scene_desc.h"

namespace drt {

struct BallSceneOptions {
    bool glossy = false;  ///< balls reflect with a spread of 3 degrees, two bounces
    bool lens = false;
    bool motion = false;  ///< every third ball moves during the exposure
};

SceneDesc ball_scene(const BallSceneOptions& = {});

}  // namespace drt
