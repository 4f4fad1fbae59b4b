#include <cmath>

#include "drt/plan/motion_build.h"
#include "drt/plan/prepare.h"

namespace drt {

namespace {

bool is_zero(const Vec3d& v) { return v == Vec3d{}; }

// Do the Bezier curves (or the path) move the camera between shutter open and close?
bool moves(const CameraModel<double>& c) {
    const View<double> a = view_at(c, 0.0);
    for (const double u : {0.25, 0.5, 0.75, 1.0}) {  // control polygons of a constant curve are constant everywhere
        const View<double> b = view_at(c, u);
        if (!is_zero(a.eye - b.eye) || !is_zero(a.forward - b.forward) || !is_zero(a.up - b.up) ||
            a.pixel_size != b.pixel_size || a.focus != b.focus)
            return true;
    }
    return false;
}

}  // namespace

CameraModel<double> build_camera(const RenderSettings& settings, const Camera& c, const Exposure& e) {
    CameraModel<double> m;
    m.film = {settings.width, settings.height};
    m.lens = {c.lens.aperture_radius, c.lens.distribution == Lens::Distribution::radial,
              c.lens.focus_surface == Lens::FocusSurface::sphere};
    m.eyes = c.positions;
    m.targets = c.targets;
    m.s0 = e.s0;
    m.s1 = e.s1;
    const auto exposed = [&](const auto& start, const auto& end) {
        using V = std::decay_t<decltype(start)>;
        const V span = end - start;
        return Linear<V>{start + span * e.s0, start + span * e.s1};
    };
    m.up = exposed(c.up_start, c.up_end.value_or(c.up_start));
    const double fov = radians(c.fov_degrees_start);
    m.fov = exposed(fov, c.fov_degrees_end ? radians(*c.fov_degrees_end) : fov);
    if (c.lens.focus_start || c.lens.focus_end) {  // else the target is in focus, wherever it is
        const double start = c.lens.focus_start.value_or(length(c.targets.front() - c.positions.front()));
        m.focus = exposed(start, c.lens.focus_end.value_or(start));
    }
    if (c.motion) {
        m.path = build_path(*c.motion, e.time0, e.time1);
        m.eyes = {c.positions.front()};
        m.targets = {c.targets.front()};
    }
    m.switch_ratio = float(c.shutter.switch_ratio);
    m.moving = moves(m);
    return m;
}

}  // namespace drt
