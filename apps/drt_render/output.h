#pragma once
// Pictures on disk: what is written beside the pixels, and snapshots while rendering.

#include <cstdint>

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

/// drt:version, drt:isa, drt:sceneHash, drt:spp, drt:seed, drt:frame, drt:sceneTime, drt:renderSeconds, drt:error ...
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
