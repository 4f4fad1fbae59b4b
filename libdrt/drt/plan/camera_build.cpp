#include <algorithm>
#include <cmath>

#include "drt/plan/curve_build.h"
#include "drt/plan/motion_build.h"
#include "drt/plan/prepare.h"

namespace drt {

namespace {

// The part of the exposure that lies within the camera's video: outside of it curves stand still at their ends, which
// are all that has been checked.
Stretch exposed_part(CameraModel<double>& m, const Exposure& e) {
    const Stretch s{std::clamp(e.s0, 0.0, 1.0), std::clamp(e.s1, 0.0, 1.0)};
    if (s.from < s.to) {
        m.begin = (s.from - e.s0) / (e.s1 - e.s0);
        m.inv_length = (e.s1 - e.s0) / (s.to - s.from);
    }
    return s;
}

void set_eye(CameraModel<double>& m, const Camera& c, const Exposure& e, const Stretch& s) {
    if (c.motion) {
        m.path = build_path(*c.motion, e.time0, e.time1);
        m.view = {c.targets.front() - c.positions.front()};
        return;
    }
    m.eye = bezier_curve(c.positions, s);
    m.view = bezier_curve(c.targets, s);
    m.view.resize(std::max(m.view.size(), m.eye.size()));
    for (size_t k = 0; k < m.eye.size(); ++k) m.view[k] -= m.eye[k];
}

// By its length at the start or the end: of any other it might underflow in float.
void set_up(CameraModel<double>& m, const Camera& c, const Stretch& s) {
    const Vec3d end = c.up_end.value_or(c.up_start);
    const double scale = std::max(length(c.up_start), length(end));
    m.up = linear_curve(c.up_start / scale, end / scale, s);
}

double half_width(double fov_degrees) {
    constexpr double least = 1e-150;  // its inverse is finite
    return std::max(std::tan(radians(fov_degrees) / 2), least);
}

void set_zoom(CameraModel<double>& m, const Camera& c, const Stretch& s) {
    const double start = c.fov_degrees_start, end = c.fov_degrees_end.value_or(start);
    const double a = half_width(start), b = half_width(end), pixels = 2.0 / m.film.width;
    if (start == end || c.zoom == Camera::Zoom::image_width) {
        m.pixel_width = linear_curve(a, b, s);
    } else if (c.zoom == Camera::Zoom::focal_length) {
        const double nearest = std::min(a, b);  // so that distances are at most 1
        m.pixel_width = {nearest};
        m.image_distance = linear_curve(nearest / a, nearest / b, s);
    } else {
        m.pixel_width = sine_curve(radians(start) / 2, radians(end) / 2, s);
        m.image_distance = cosine_curve(radians(start) / 2, radians(end) / 2, s);
    }
    for (double& k : m.pixel_width) k *= pixels;
}

void set_focus(CameraModel<double>& m, const Camera& c, const Stretch& s) {
    if (!c.lens.focus_start && !c.lens.focus_end) return;  // the target is in focus, wherever it is
    const double start = c.lens.focus_start.value_or(length(c.targets.front() - c.positions.front()));
    m.focus = linear_curve(start, c.lens.focus_end.value_or(start), s);
}

void set_curves(CameraModel<double>& m, const Camera& c, const Exposure& e, const Stretch& s) {
    set_eye(m, c, e, s);
    set_up(m, c, s);
    set_zoom(m, c, s);
    set_focus(m, c, s);
}

// The eye is away from its target, and up is away from the view.
bool has_view(const CameraModel<double>& m, const Camera& c) {
    constexpr double rounding = 1e-12;
    const Vec3d view = m.view[0], up = m.up[0];
    return length(view) > rounding * length(c.targets.front() - c.positions.front()) && length(up) > rounding &&
           shows_up(normalize(view), up);
}

bool moves(const CameraModel<double>& m) {
    const auto changes = [](const auto&... curve) { return ((curve.size() > 1) || ...); };
    return changes(m.eye, m.view, m.up, m.pixel_width, m.image_distance, m.focus) || !is_constant(m.path);
}

}  // namespace

CameraModel<double> build_camera(const RenderSettings& settings, const Camera& c, const Exposure& e) {
    CameraModel<double> m;
    m.film = {settings.width, settings.height};
    m.lens = {c.lens.aperture_radius, c.lens.distribution == Lens::Distribution::radial,
              c.lens.focus_surface == Lens::FocusSurface::sphere};
    m.switch_ratio = float(c.shutter.switch_ratio);
    const Stretch s = exposed_part(m, e);
    set_curves(m, c, e, s);
    if (s.from == s.to && s.from < 1) {
        // An instant in which the eye is at its target or right above it has no view: it is as just after.
        for (const double later : {1e-9, 1e-6, 1e-3}) {
            if (has_view(m, c)) break;
            const double at = std::min(s.from + later, 1.0);
            set_curves(m, c, e, {at, at});
        }
    }
    m.moving = moves(m);
    return m;
}

}  // namespace drt
