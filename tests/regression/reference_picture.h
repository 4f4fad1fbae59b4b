#pragma once
// A reference picture on disk: one EXR with the mean (R, G, B: float, scene-linear) and its standard error (error.R,
// error.G, error.B: half). Both are rounded as far as the error allows, which makes the files small: the mean to a step
// of at most 1/4 of its error (that adds less than 1/190 to the variance), the error to 3 bits after the first (below
// 3e-8 to 0).

#include <string>

#include "drt/scene/scene_desc.h"
#include "support/estimate.h"

namespace drt {

struct ReferencePicture {
    PictureEstimate picture;
    int seeds = 0;
    int spp = 0;             ///< samples per pixel of each seed
    std::string scene_hash;  ///< of the scene that was rendered
    std::string version;     ///< of drt that rendered it
};

/// Replaces the file. Throws std::exception when that fails.
void write_reference(const std::string& path, const ReferencePicture&);

/// Throws std::exception when there is no such file or it is not a reference picture.
ReferencePicture read_reference(const std::string& path);

/// Tells whether a scene is the one that a reference shows: a hash of everything that its file says. File references
/// count as written relative to `folder`.
std::string hash_scene(const SceneDesc&, const std::string& folder);

}  // namespace drt
