#pragma once
// Which camera records a frame, when its samples are taken and along which rays.

#include "drt/scene/scene_desc.h"
#include "reference/random.h"
#include "reference/shapes.h"

namespace drt::reference {

/// The first camera whose interval [video_start, video_end) holds the video time; if there is none, the first whose
/// inclusive end it is. Throws std::invalid_argument if there is none of these either.
const Camera& camera_at(const SceneDesc&, double video_time);

/// Video time of one sample: the shutter opens at `opening` and passes the trapezoid's share of light.
double sample_video_time(const Shutter&, double opening, double fps, Random&);

/// Scene time that the camera shows at a video time. An exposure past the end of its video keeps its pace.
double scene_time(const Camera&, double video_time);

/// The ray through image position (x, y) in pixels, y down, from a random point of the lens.
Ray camera_ray(const Camera&, double video_time, double x, double y, int width, int height, Random&);

}  // namespace drt::reference
