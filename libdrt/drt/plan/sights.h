#pragma once
// What shines by itself, and how bright: what a path may meet without having been aimed at it. A picture's error is
// judged by it (render/unseen_light.h).

#include <vector>

#include "drt/base/color.h"

namespace drt {

struct SceneDesc;
struct PreparedScene;

/// A visible light.
struct VisibleSource {
    float radiance = 0;  ///< of its brightest channel
    double pixels = 0;   ///< about how many it would cover if the camera looked at it
};

struct Sights {
    std::vector<VisibleSource> sources;
    double glow = 0;             ///< the most that background and ambient terms send along one path
    double gain = 1;             ///< by which materials brighten what a path meets, at most
    bool by_scattering = false;  ///< paths meet things by reflection and refraction, too
};

Sights find_sights(const SceneDesc&, const PreparedScene&);

}  // namespace drt
