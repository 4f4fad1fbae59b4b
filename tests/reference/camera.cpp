#include "reference/camera.h"

#include <stdexcept>

#include "drt/base/constants.h"
#include "reference/motion.h"

namespace drt::reference {
namespace {

/// How far the camera is on its way from start to end; at its start if its video has no end. Before and after its
/// video it stands still.
double progress(const Camera& camera, double video_time) {
    if (!camera.video_end || video_time <= camera.video_start) return 0;
    if (video_time >= *camera.video_end) return 1;
    return (video_time - camera.video_start) / (*camera.video_end - camera.video_start);
}

/// Implicit at both ends, the focus follows the target. Implicit at the start only, it leaves from the first target.
double focus_at(const Camera& camera, double s, double target_distance) {
    const Lens& lens = camera.lens;
    if (!lens.focus_start && !lens.focus_end) return target_distance;
    const double start = lens.focus_start.value_or(length(camera.targets.front() - camera.positions.front()));
    return start * (1 - s) + lens.focus_end.value_or(start) * s;
}

Vec3d bezier(std::vector<Vec3d> points, double s) {  // de Casteljau
    if (points.empty()) throw std::invalid_argument("a camera needs positions and targets");
    while (points.size() > 1) {
        for (size_t i = 0; i + 1 < points.size(); ++i) points[i] = points[i] * (1 - s) + points[i + 1] * s;
        points.pop_back();
    }
    return points.front();
}

template <class T>
T mix(const T& start, const std::optional<T>& end, double s) {
    return end ? start * (1 - s) + *end * s : start;
}

/// Half of what the picture's width spans at distance 1.
double half_width_at(const Camera& camera, double s) {
    const double start = camera.fov_degrees_start, end = camera.fov_degrees_end.value_or(start);
    const double a = std::tan(radians(start / 2)), b = std::tan(radians(end / 2));
    switch (camera.zoom) {
        case Camera::Zoom::angle:
            return std::tan(radians(start * (1 - s) + end * s) / 2);
        case Camera::Zoom::image_width:
            return a * (1 - s) + b * s;
        case Camera::Zoom::focal_length:
            return 1 / ((1 - s) / a + s / b);
    }
    throw std::invalid_argument("an unknown zoom");
}

struct View {
    Vec3d eye, forward, right, up;
    double target_distance;
};

View view_at(const Camera& camera, double s, double time) {
    View view;
    Vec3d up = mix(camera.up_start, camera.up_end, s);
    const bool keyframed = camera.motion.has_value();
    view.eye = keyframed ? camera.positions.front() : bezier(camera.positions, s);
    const Vec3d to_target = (keyframed ? camera.targets.front() : bezier(camera.targets, s)) - view.eye;
    view.target_distance = length(to_target);
    view.forward = normalize(to_target);
    if (keyframed) {  // replaces the eye and turns the whole view, its up included
        const Pose pose = pose_at(*camera.motion, time);
        view.eye = pose.position;
        view.forward = rotate(pose.orientation, view.forward);
        up = rotate(pose.orientation, up);
    }
    view.right = normalize(cross(view.forward, up));
    view.up = cross(view.right, view.forward);
    return view;
}

}  // namespace

const Camera& camera_at(const SceneDesc& scene, double video_time) {
    constexpr double forever = std::numeric_limits<double>::infinity();
    for (const Camera& camera : scene.cameras)
        if (video_time >= camera.video_start && video_time < camera.video_end.value_or(forever)) return camera;
    for (const Camera& camera : scene.cameras)
        if (camera.video_end_inclusive && video_time == camera.video_end) return camera;
    throw std::invalid_argument("no camera records this frame");
}

double sample_video_time(const Shutter& shutter, double opening, double fps, Random& random) {
    const double duration = shutter.duration.value_or(1 / fps);
    if (duration == 0) return opening;
    const double switching = duration * shutter.switch_ratio / 2;
    for (;;) {
        const double t = random.between(0, duration);
        const double weight = switching > 0 ? std::min({1.0, t / switching, (duration - t) / switching}) : 1.0;
        if (random.uniform() < weight) return opening + t;
    }
}

double scene_time(const Camera& camera, double video_time) {
    const double start = camera.time_start.value_or(camera.video_start);
    if (!camera.video_end) return start + (video_time - camera.video_start);
    const double end = camera.time_end.value_or(start + (*camera.video_end - camera.video_start));
    const double share = (video_time - camera.video_start) / (*camera.video_end - camera.video_start);
    return start + (end - start) * share;
}

Ray camera_ray(const Camera& camera, double video_time, double x, double y, int width, int height, Random& random) {
    const double s = progress(camera, video_time);
    const View view = view_at(camera, s, scene_time(camera, video_time));
    const double half_width = half_width_at(camera, s);
    const Vec3d through = view.forward + view.right * ((2 * x / width - 1) * half_width) +
                          view.up * ((height - 2 * y) / width * half_width);
    const Lens& lens = camera.lens;
    if (lens.aperture_radius == 0) return {view.eye, normalize(through)};
    // plane: `through` is at distance 1 along the view direction; sphere: distance along the ray itself.
    const Vec3d unit = lens.focus_surface == Lens::FocusSurface::plane ? through : normalize(through);
    const Vec3d aim = view.eye + unit * focus_at(camera, s, view.target_distance);
    const Vec2d p = random.disc(lens.distribution == Lens::Distribution::radial);
    const Vec3d origin = view.eye + (view.right * p.x + view.up * p.y) * lens.aperture_radius;
    return {origin, normalize(aim - origin)};
}

}  // namespace drt::reference
