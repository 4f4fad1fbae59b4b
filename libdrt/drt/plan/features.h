#pragma once
// What a scene needs. One place that answers it; the stage list is composed from this and nothing else.

#include <string>
#include <vector>

namespace drt {

struct Features {
    bool pixel_filter = false;  ///< samples spread over the filter instead of the pixel's centre
    bool lens = false;
    bool time = false;  ///< rays differ in time: something moves while the shutter is open
    bool moving_camera = false;
    bool planes = false;
    bool textures = false;
    bool visible_lights = false;
    bool lights = false;
    bool light_samples = false;  ///< some light has an area
    bool specular = false;       ///< some material has highlights
    bool scatter = false;        ///< something reflects or refracts
    bool refraction = false;
    bool glossy = false;  ///< some lobe is not sharp
    bool double_precision = false;
    friend bool operator==(const Features&, const Features&) = default;
};

/// One line of --explain.
struct Decision {
    std::string what;  ///< "lens"
    bool kept = false;
    std::string why;  ///< "aperture_radius is 0"
};

using Explanation = std::vector<Decision>;

}  // namespace drt
