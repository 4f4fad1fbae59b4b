#include "drt/plan/exposure.h"

#include <fmt/format.h>

#include "drt/scene/camera_time.h"

namespace drt {

namespace {

std::string frame_list(const FrameRange& r) {
    if (r.empty()) return "no frame";
    return std::isfinite(r.end) ? fmt::format("frames {:.0f}..{:.0f}", r.first, r.end - 1)
                                : fmt::format("frames {:.0f}..", r.first);
}

std::string recorded_frames(const SceneDesc& scene) {
    std::string out;
    for (const Camera& c : scene.cameras) {
        if (!out.empty()) out += ", ";
        out += fmt::format("camera \"{}\" records {}", c.name, frame_list(recorded_frames(c, scene.render.fps)));
    }
    return out;
}

// Where two cameras touch, the cut is already the second one's: an inclusive end counts only if nobody else records.
bool records(const Camera& c, int frame, double fps, bool with_end) {
    return recorded_frames(c, fps, with_end && c.video_end_inclusive).contains(frame);
}

int find_camera(const SceneDesc& scene, int frame, double video_time, const std::string& name) {
    for (const bool with_end : {false, true})
        for (size_t i = 0; i < scene.cameras.size(); ++i) {
            const Camera& c = scene.cameras[i];
            if (name.empty() ? records(c, frame, scene.render.fps, with_end) : c.name == name) return int(i);
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
    const double open = e.video_time, close = open + exposure_duration(c, scene.render.fps);
    e.s0 = video_share(c, open);
    e.s1 = video_share(c, close);
    e.time0 = scene_time(c, open);
    e.time1 = scene_time(c, close);
    return e;
}

}  // namespace drt
