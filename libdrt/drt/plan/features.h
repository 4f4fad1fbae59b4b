#pragma once
// What a scene needs. One place that answers it; the stage list is composed from this and nothing else.

#include <string>
#include <vector>

#include "drt/base/diagnostic.h"

namespace drt {

#ifdef DRT_BARE
/// A feature that this build leaves out (CMake's DRT_BARE): the constant false, so that the compiler drops all that
/// depends on it. benchmarks/instruction_counts shows with it that scenes without these features pay nothing for them.
struct OptionalFeature {
    constexpr OptionalFeature(bool needed = false) {
        if (needed) throw Error(ErrorKind::usage, "this build has no lens, time, textures and scatter (DRT_BARE)");
    }
    constexpr operator bool() const { return false; }
};
#else
using OptionalFeature = bool;
#endif

struct Features {
    bool pixel_filter = false;  ///< samples spread over the filter instead of the pixel's centre
    OptionalFeature lens = false;
    OptionalFeature time = false;  ///< rays differ in time: something moves while the shutter is open
    OptionalFeature moving_camera = false;
    bool planes = false;
    OptionalFeature textures = false;
    bool visible_lights = false;
    bool lights = false;
    bool light_samples = false;       ///< some light has an area
    bool light_tree = false;          ///< lights with falloff are so many that a tree chooses
    bool specular = false;            ///< some material has highlights
    OptionalFeature scatter = false;  ///< something reflects or refracts
    OptionalFeature refraction = false;
    OptionalFeature nested_media = false;  ///< several bodies refract: they may overlap
    OptionalFeature eye_media = false;     ///< the eye may be inside a body that refracts
    OptionalFeature glossy = false;        ///< some lobe is not sharp
    OptionalFeature lobe_lights = false;   ///< glossy reflections may meet lights that are sampled, too
    OptionalFeature brightens = false;     ///< some material sends on more light than it receives
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
