#include "drt/plan/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace drt {

namespace {

// Where two cameras touch, the cut is already the second one's: the end belongs to an interval only if nobody else
// begins there.
bool records(const Camera& c, double video_time, bool with_end) {
    if (video_time < c.video_start) return false;
    return !c.video_end || video_time < *c.video_end || (with_end && video_time == *c.video_end);
}

std::string recorded_frames(const SceneDesc& scene) {
    std::string out;
    for (const Camera& c : scene.cameras) {
        if (!out.empty()) out += ", ";
        const double first = std::ceil(c.video_start * scene.render.fps);
        out += fmt::format("camera \"{}\" records frames {:.0f}..", c.name, first);
        if (c.video_end) out += fmt::format("{:.0f}", std::floor(*c.video_end * scene.render.fps));
    }
    return out;
}

int find_camera(const SceneDesc& scene, int frame, double video_time, const std::string& name) {
    for (const bool with_end : {false, true})
        for (size_t i = 0; i < scene.cameras.size(); ++i) {
            const Camera& c = scene.cameras[i];
            if (name.empty() ? records(c, video_time, with_end) : c.name == name) return int(i);
        }
    if (name.empty())
        throw Error(ErrorKind::usage, fmt::format("no camera records frame {} (video time {} s): {}", frame, video_time,
                                                  recorded_frames(scene)));
    std::vector<std::string_view> names;
    for (const Camera& c : scene.cameras) names.push_back(c.name);
    throw Error(ErrorKind::usage, {{Severity::error,
                                    {},
                                    "no such camera",
                                    name,
                                    fmt::format("one of: {}", fmt::join(names, ", ")),
                                    nearest_word(name, names)}});
}

}  // namespace

Exposure exposure_of_frame(const SceneDesc& scene, int frame, const std::string& camera_name) {
    Exposure e;
    e.video_time = frame / scene.render.fps;
    e.camera = find_camera(scene, frame, e.video_time, camera_name);
    const Camera& c = scene.cameras[size_t(e.camera)];
    const double time_start = c.time_start.value_or(c.video_start);
    const double open = e.video_time;
    const double close = open + c.shutter.duration.value_or(1 / scene.render.fps);
    if (!c.video_end) {  // for ever: nothing goes from start to end, time runs at its natural speed
        e.time0 = time_start + (open - c.video_start);
        e.time1 = time_start + (close - c.video_start);
        return e;
    }
    const double length = *c.video_end - c.video_start;
    const double time_end = c.time_end.value_or(time_start + length);
    // Not clamped: an exposure that begins on the last frame runs on past the end, at the same pace.
    const auto parameter = [&](double t) { return length > 0 ? (t - c.video_start) / length : 0.0; };
    e.s0 = parameter(open);
    e.s1 = parameter(close);
    e.time0 = time_start + e.s0 * (time_end - time_start);
    e.time1 = time_start + e.s1 * (time_end - time_start);
    return e;
}

}  // namespace drt
