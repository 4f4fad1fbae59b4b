#include <algorithm>
#include <numeric>

#include "drt/scene/camera_time.h"
#include "drt/scene/check_fields.h"

namespace drt {
namespace {

// ---- the view ------------------------------------------------------------------------------------------------------

struct View {
    std::string_view when;  // "" or " at the end"
    Vec3d eye, target, up;
    std::string_view which_up;  // "start" or "end"
    bool eye_and_target_are_fine;
};

void check_view(Report& report, const ScenePath& at, const View& view, const FineFields& fine) {
    if (!view.eye_and_target_are_fine) return;
    const Vec3d direction = view.target - view.eye;
    // closer than the rounding of the coordinates is the same point
    const double scale = std::max(length(view.target), length(view.eye));
    const std::string when(view.when);
    const ScenePath ups = at / "up", up = ups / view.which_up;
    if (length(direction) < 1e-30 || length(direction) < 1e-14 * scale)
        report.error(at / "targets", "the camera's target is its position" + when, to_text(view.target),
                     "a point away from the eye " + to_text(view.eye));
    else if (fine(up) && nearly_parallel(direction, view.up))
        report.error(up, report.name(up, "up") + " is parallel to the view" + when, to_text(view.up),
                     "a direction away from the view " + to_text(direction) + ", for example " +
                         to_text(std::abs(direction.y) > std::abs(direction.z) ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0}));
}

void check_views(Report& report, const ScenePath& at, const Camera& camera, const FineFields& fine) {
    if (camera.positions.empty() || camera.targets.empty()) return;
    const ScenePath eyes = at / "positions", targets = at / "targets";
    const View start{"",      camera.positions.front(), camera.targets.front(), camera.up_start,
                     "start", fine(eyes[0], targets[0])};
    check_view(report, at, start, fine);
    const std::size_t last_eye = camera.motion ? 0 : camera.positions.size() - 1;  // motion replaces the curves
    const std::size_t last_target = camera.motion ? 0 : camera.targets.size() - 1;
    const View end{" at the end",
                   camera.positions[last_eye],
                   camera.targets[last_target],
                   camera.up_end.value_or(camera.up_start),
                   camera.up_end ? "end" : "start",
                   fine(eyes[last_eye], targets[last_target])};
    const bool changes = !(end.eye == start.eye && end.target == start.target && end.up == start.up);
    if (changes && camera.video_end) check_view(report, at, end, fine);
}

// Half-way between opposite vectors there is none.
void check_roll(Report& report, const ScenePath& at, const Camera& camera, const FineFields& fine) {
    const ScenePath ups = at / "up", end = ups / "end";
    if (camera.up_end && fine(ups / "start", end) && nearly_parallel(camera.up_start, *camera.up_end) &&
        dot(camera.up_start, *camera.up_end) < 0)
        report.warning(end, report.name(end, "up") + " is the opposite of its start: the picture turns over at once",
                       to_text(*camera.up_end), "a direction that says which way round it turns");
}

// ---- time ----------------------------------------------------------------------------------------------------------

void check_endless(Report& report, const ScenePath& at, const Camera& camera, const FineFields& fine) {
    if (camera.positions.size() > 1)
        report.error(at / "positions", "several positions need a video_end", {},
                     "video_end, the time at which the curve ends");
    if (camera.targets.size() > 1)
        report.error(at / "targets", "several targets need a video_end", {},
                     "video_end, the time at which the curve ends");
    const auto warn = [&](const ScenePath& path, bool set) {
        if (set && fine(path)) report.warning(path, "has no effect without a video_end");
    };
    warn(at / "up" / "end", camera.up_end.has_value());
    warn(at / "fov_degrees" / "end", camera.fov_degrees_end.has_value());
    warn(at / "lens" / "focus_distance" / "end", camera.lens.focus_end.has_value());
    warn(at / "time_end", camera.time_end.has_value());
    warn(at / "video_end_inclusive", camera.video_end_inclusive);
}

bool interval_is_fine(const ScenePath& at, const FineFields& fine) {
    return fine(at / "video_start", at / "video_end");
}

void check_interval(Report& report, const ScenePath& at, const Camera& camera, const FineFields& fine,
                    std::optional<double> fps) {
    if (!interval_is_fine(at, fine)) return;
    if (!camera.video_end)
        check_endless(report, at, camera, fine);
    else if (!(*camera.video_end > camera.video_start))
        report.error(at / "video_end", "the camera's video ends before it starts", to_text(*camera.video_end),
                     "more than video_start " + to_text(camera.video_start));
    else if (fps && recorded_frames(camera, *fps).empty())
        report.warning(at / "video_end", "no frame lies in the camera's video", to_text(*camera.video_end),
                       "a longer one: at fps " + to_text(*fps) + " frames are " + to_text(1 / *fps) + " s apart");
}

std::string camera_text(const SceneDesc& scene, std::size_t i) {
    return scene.cameras[i].name.empty() ? "camera " + std::to_string(i + 1) : '\'' + scene.cameras[i].name + '\'';
}

// Sweeps over the cameras by first frame and compares each with the one that has recorded longest so far.
void check_overlaps(Report& report, const ScenePath& list, const SceneDesc& scene, double fps) {
    const auto frames = [&](std::size_t i) { return recorded_frames(scene.cameras[i], fps, false); };
    const auto start = [&](std::size_t i) { return frames(i).first; };
    const auto end = [&](std::size_t i) { return frames(i).end; };
    std::vector<std::size_t> order(scene.cameras.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return start(a) < start(b); });
    for (std::size_t i = 1, longest = order.empty() ? 0 : order[0]; i < order.size(); ++i) {
        const std::size_t here = order[i];
        if (start(here) < end(longest) && !frames(here).empty()) {
            const std::size_t winner = std::min(here, longest), other = std::max(here, longest);
            report.warning(list[other] / "video_start", camera_text(scene, other) + " and " +
                                                            camera_text(scene, winner) + " record at the same time; " +
                                                            camera_text(scene, winner) + " comes first and does");
        }
        if (end(here) > end(longest)) longest = here;
    }
}

}  // namespace

void check_cameras(Report& report, const SceneDesc& scene) {
    const ScenePath root, list = root / "cameras";
    check_unique_names(report, list, scene.cameras);
    std::optional<double> fps;  // none that could be read: nothing is said of frames
    if (scene.render.fps > 0 && std::isfinite(scene.render.fps) && !scene.sources.is_unread("render.fps"))
        fps = scene.render.fps;
    bool intervals_are_fine = true;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i];
        const ScenePath at = list[i];
        const FineFields fine = check_fields(report, at, camera);
        if (camera.motion) check_motion(report, at / "motion", *camera.motion, fine);
        check_views(report, at, camera, fine);
        check_roll(report, at, camera, fine);
        if (camera.zoom != Camera::Zoom::angle && !camera.fov_degrees_end)
            report.warning(at / "zoom", "has no effect without an end of fov_degrees");
        check_interval(report, at, camera, fine, fps);
        intervals_are_fine = intervals_are_fine && interval_is_fine(at, fine);
        if (camera.motion && camera.positions.size() > 1)
            report.warning(at / "positions", "motion replaces the positions after the first");
        if (camera.motion && camera.targets.size() > 1)
            report.warning(at / "targets", "motion replaces the targets after the first");
    }
    if (scene.cameras.empty()) report.error(list, "the scene has no camera", {}, "at least one");
    if (intervals_are_fine && fps) check_overlaps(report, list, scene, *fps);
}

}  // namespace drt
