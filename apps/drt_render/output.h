#pragma once
// Pictures on disk: what is written beside the pixels, and snapshots while rendering.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "apps/input_files.h"
#include "drt/render/render.h"
#include "options.h"

namespace drt {

/// 128 bits over the scene's YAML text: equal scenes, equal hash, wherever they were written.
std::string scene_hash(const SceneDesc&);

struct OutputInfo {
    std::string scene_hash;
    int frame = 0;
    const RenderPlan* plan = nullptr;
    std::uint32_t seed = 0;
};

/// Where the pictures of one frame go.
std::vector<std::string> output_paths(const RenderArguments&, int frame);
std::optional<Snapshot> frame_snapshot(const RenderArguments&, int frame);

/// Before anything is read or rendered: all files that the run will write. Throws Error (output) for what cannot be
/// written, and Error (usage) when two pictures, or a picture and the snapshot, have the same path or one has the
/// scene's.
FileSet check_outputs(const RenderArguments&);

/// drt:version, drt:isa, drt:precision, drt:sceneHash, drt:spp, drt:seed, drt:frame, drt:videoTime, drt:sceneTime and
/// drt:sceneTimeClose (when the shutter opens and closes, in the scene's seconds), drt:renderSeconds, and,
/// drt:errorEstimate (what is known of the error) and, if it is a number, drt:rmse and drt:relativeError.
Metadata metadata(const OutputInfo&, const RenderResult&);

/// Writes the picture so far whenever the interval has passed.
class SnapshotWriter {
public:
    SnapshotWriter(Snapshot snapshot, DisplayTransform display);
    void pass_done(const Film&, const Progress&, const OutputInfo&);

private:
    Snapshot snapshot_;
    DisplayTransform display_;
    double last_ = 0;
    bool first_ = true;
};

}  // namespace drt
