#include "drt/scene/camera_time.h"

#include <limits>

namespace drt {

namespace {

// Video time in frames. Times are decimals, sums of decimals (the end of the camera above) and quotients of such; what
// is this near to a whole frame is meant to be on it.
double in_frames(double video_time, double fps) {
    const double frames = video_time * fps, nearest = std::round(frames);
    return std::abs(frames - nearest) <= 1e-9 + 1e-12 * std::abs(frames) ? nearest : frames;
}

}  // namespace

FrameRange recorded_frames(const Camera& c, double fps, bool with_end) {
    const double first = std::ceil(in_frames(c.video_start, fps));
    if (!c.video_end) return {first, std::numeric_limits<double>::infinity()};
    const double end = in_frames(*c.video_end, fps);
    return {first, with_end ? std::floor(end) + 1 : std::ceil(end)};
}

double video_share(const Camera& c, double video_time) {
    return c.video_end ? (video_time - c.video_start) / (*c.video_end - c.video_start) : 0;
}

double scene_time(const Camera& c, double video_time) {
    const double start = c.time_start.value_or(c.video_start);
    if (!c.video_end) return start + (video_time - c.video_start);
    const double end = c.time_end.value_or(start + (*c.video_end - c.video_start));
    return start + video_share(c, video_time) * (end - start);
}

double exposure_duration(const Camera& c, double fps) { return c.shutter.duration.value_or(1 / fps); }

}  // namespace drt
