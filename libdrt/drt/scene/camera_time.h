#pragma once
// When a camera records, and which scene time it shows: the one place that knows the implicit values of its times.

#include <cmath>

#include "drt/scene/scene_desc.h"

namespace drt {

/// Frames first <= k < end. Whole numbers, but doubles: a video without an end has infinitely many.
struct FrameRange {
    double first = 0, end = 0;
    bool empty() const { return !(first < end); }
    bool contains(double frame) const { return frame >= first && frame < end; }
};

/// The frames whose video time lies in [video_start, video_end), or in [video_start, video_end] if `with_end`. A frame
/// that is off a boundary by no more than the rounding of the times counts as on it: at 10 fps frame 3 is at 0.1 + 0.2.
FrameRange recorded_frames(const Camera&, double fps, bool with_end);

/// The frames that the camera records where no other camera is in its way.
inline FrameRange recorded_frames(const Camera& c, double fps) {
    return recorded_frames(c, fps, c.video_end_inclusive);
}

/// Share of the camera's video that has passed: 0 at video_start, 1 at video_end, outside of that beyond; always 0 of a
/// video without an end.
double video_share(const Camera&, double video_time);

/// Scene time that is shown at a video time. Before and after the camera's video it runs at the same pace.
double scene_time(const Camera&, double video_time);

/// Seconds of video for which a frame is exposed.
double exposure_duration(const Camera&, double fps);

}  // namespace drt
