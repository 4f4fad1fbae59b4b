#pragma once
// Small scenes that together use every feature of the model, alone and combined.

#include <optional>
#include <string>
#include <vector>

#include "drt/scene/scene_desc.h"

namespace drt {

struct PictureCase {
    std::string name;
    SceneDesc scene;  ///< of the size to be compared
    int frame = 0;
    int reference_spp = 256;
    int render_spp = 128;
    double tolerance = 1e-7;  ///< of the mean of a block: what drt's texture filter blurs and the reference does not
    /// How bright the samples are of which the reference meets so few in a block that it may know nothing of them (a
    /// glossy lobe's of small visible lights); 0: there are none.
    double rare = 0;
    /// What the reference renders, where it cannot render the scene as it stands.
    std::optional<SceneDesc> reference_scene{};
};

/// Shapes, lights and surfaces. `texture_folder` must exist; textures are written there.
std::vector<PictureCase> surface_pictures();
std::vector<PictureCase> light_pictures();
std::vector<PictureCase> texture_pictures(const std::string& texture_folder);
/// Lens, shutter, motion, time mapping, filters.
std::vector<PictureCase> camera_pictures(const std::string& texture_folder);

/// All of them.
std::vector<PictureCase> all_pictures(const std::string& texture_folder);
/// One of them. Throws std::invalid_argument for a name that none has.
PictureCase find_picture(const std::string& name, const std::string& texture_folder);

}  // namespace drt
