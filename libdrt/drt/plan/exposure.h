#pragma once
// Which camera records a frame, and which stretch of video and scene time the exposure covers (docs/scene-format.md,
// Cameras).

#include "drt/scene/scene_desc.h"

namespace drt {

struct Exposure {
    int camera = -1;              ///< index in SceneDesc::cameras
    double s0 = 0, s1 = 0;        ///< video_share at shutter open and close
    double time0 = 0, time1 = 0;  ///< scene time at shutter open and close; time1 < time0 when time runs backwards
    double video_time = 0;        ///< of the frame, seconds
};

/// Frame k opens the shutter at video time k / fps. Throws Error (usage) when no camera records that frame, naming the
/// frames that are recorded. `camera_name` picks a camera; empty: the first that records the frame.
Exposure exposure_of_frame(const SceneDesc&, int frame, const std::string& camera_name = {});

}  // namespace drt
