// Settings and cameras.
#include <algorithm>
#include <cmath>
#include <string>

#include "drt/base/constants.h"
#include "drt/formats/legacy_map.h"
#include "drt/scene/value_text.h"

namespace drt {
namespace {

constexpr double largest_spp = 1 << 20;

std::optional<double> optional_real(const LegacyElement& e, std::string_view attribute) {
    if (e.implicit(attribute)) return {};
    return e.real(attribute);
}

/// The 2008 program traced blur x dof x n x n primary rays a pixel; as many paths are the converted scene's spp.
void map_sample_count(LegacyMapping& m, const LegacyElement& e) {
    const double n = std::max(1, e.whole("interpolate_samples"));
    const double wanted = std::max(1, e.whole("blur_samples")) * double(std::max(1, e.whole("dof_samples"))) * n * n;
    m.scene.render.spp = int(std::min(wanted, largest_spp));
    m.mark("render.spp", e.place);
    m.report.note(e.place, "spp = " + std::to_string(m.scene.render.spp) +
                               ", the product of blur_samples, dof_samples and interpolate_samples squared" +
                               (wanted > largest_spp ? ", cut down to the largest sensible number" : ""));
}

/// Samples nested in each path's: every path of drt takes one, and the picture converges to the same (model.md 3).
void note_dropped_counts(LegacyMapping& m, const LegacyElement& e) {
    for (const char* attribute : {"soft_shadow_samples", "diffuse_reflection_samples", "diffuse_refraction_samples"})
        if (const int count = e.whole(attribute); count > 1)
            m.report.note(e.value(attribute).place,
                          "dropped: " + std::string(attribute) + ' ' + std::to_string(count) +
                              "; it said how many samples each path takes, drt takes one in each of its paths");
}

void note_effects_off(LegacyMapping& m, const LegacyElement& e) {
    const std::pair<const char*, const char*> effects[] = {
        {"blur_samples", "the shutter opens for an instant: no motion blur"},
        {"dof_samples", "the cameras are pinholes: no depth of field"},
        {"soft_shadow_samples", "every light is a point at its centre: hard shadows"},
        {"diffuse_reflection_samples", "reflections are sharp"},
        {"diffuse_refraction_samples", "refractions are sharp"},
    };
    for (const auto& [attribute, effect] : effects)
        if (e.whole(attribute) == 0)
            m.report.note(e.value(attribute).place, std::string(attribute) + " is 0: " + effect);
}

std::optional<double> fov_degrees(LegacyMapping& m, const LegacyElement& e, std::string_view attribute) {
    const auto fov = optional_real(e, attribute);
    if (!fov) return {};
    const double half_tangent = m.options.fov == LegacyOptions::Fov::half_width ? *fov / 2 : 1 / *fov;
    const double angle = degrees(2 * std::atan(half_tangent));
    if (angle < 180) return angle;
    m.report.error(e.value(attribute).place, std::string(attribute) + " gives an angle of view of 180 degrees",
                   to_text(*fov), "a larger number");
    return {};
}

/// The file's FOV itself goes linearly from start to end, not the angle that follows from it.
Camera::Zoom zoom_of(const LegacyOptions& options) {
    return options.fov == LegacyOptions::Fov::half_width ? Camera::Zoom::image_width : Camera::Zoom::focal_length;
}

/// Legacy cameras and their implicit times. drt has one implicit length, "for ever"; the others are written out.
void map_times(LegacyMapping& m, const LegacyElement& e, const LegacyElement* next, Camera& c) {
    c.time_start = optional_real(e, "time_start");
    c.time_end = optional_real(e, "time_end");
    const Camera* above = m.scene.cameras.empty() ? nullptr : &m.scene.cameras.back();
    const double after_above = above ? above->video_end.value_or(0) : 0;
    c.video_start = optional_real(e, "video_start").value_or(after_above);
    c.video_end = optional_real(e, "video_end");
    if (c.video_end) return;
    const double shown = c.time_end ? std::fabs(*c.time_end - c.time_start.value_or(c.video_start)) : 0;
    if (shown > 0) {
        c.video_end = c.video_start + shown;
    } else if (next) {
        const auto start_of_next = optional_real(*next, "video_start");
        if (start_of_next && *start_of_next > c.video_start) c.video_end = start_of_next;
    }
}

void map_camera(LegacyMapping& m, const LegacyElement& settings, size_t index, const LegacyElement* next) {
    const LegacyElement& e = m.elements[index];
    Camera c;
    c.name = m.names.name(index);
    c.positions = std::get<std::vector<Vec3d>>(e.value("add_position").data);
    c.targets = std::get<std::vector<Vec3d>>(e.value("add_target").data);
    c.up_start = e.vector("sky_start");
    if (!e.implicit("sky_end")) c.up_end = e.vector("sky_end");
    c.fov_degrees_start = fov_degrees(m, e, "FOV_start").value_or(c.fov_degrees_start);
    c.fov_degrees_end = fov_degrees(m, e, "FOV_end");
    if (c.fov_degrees_end && *c.fov_degrees_end != c.fov_degrees_start) c.zoom = zoom_of(m.options);
    map_times(m, e, next, c);
    c.video_end_inclusive = c.video_end.has_value();
    c.lens = {m.effects.lens ? settings.real("dof_c") : 0, optional_real(e, "DOF_start"), optional_real(e, "DOF_end"),
              Lens::Distribution::radial, Lens::FocusSurface::sphere};
    c.shutter.switch_ratio = settings.real("blur_switch_ratio");
    c.shutter.duration = m.effects.blur ? optional_real(settings, "blur_duration") : 0;

    const std::string path = "cameras[" + std::to_string(m.scene.cameras.size()) + ']';
    m.mark(path, e.place);
    m.mark(path + ".name", e.name_place);
    const std::pair<const char*, const char*> places[] = {{"positions", "add_position"},
                                                          {"targets", "add_target"},
                                                          {"up", "sky_start"},
                                                          {"up.end", "sky_end"},
                                                          {"fov_degrees", "FOV_start"},
                                                          {"fov_degrees.end", "FOV_end"},
                                                          {"video_start", "video_start"},
                                                          {"video_end", "video_end"},
                                                          {"time_start", "time_start"},
                                                          {"time_end", "time_end"},
                                                          {"lens.focus_distance", "DOF_start"},
                                                          {"lens.focus_distance.end", "DOF_end"}};
    for (const auto& [field, attribute] : places) m.mark(path + '.' + field, e, attribute);
    m.mark(path + ".lens.aperture_radius", settings, "dof_c");
    m.mark(path + ".shutter.duration", settings, "blur_duration");
    m.mark(path + ".shutter.switch_ratio", settings, "blur_switch_ratio");
    m.scene.cameras.push_back(std::move(c));
}

const LegacyElement* find_settings(const LegacyMapping& m) {
    const auto it =
        std::ranges::find(m.elements, LegacyKind::settings, [](const LegacyElement& e) { return e.type->kind; });
    return it == m.elements.end() ? nullptr : &*it;
}

}  // namespace

void map_legacy_settings(LegacyMapping& m) {
    const LegacyElement& e = *find_settings(m);
    for (const LegacyElement& other : m.elements)
        if (other.type == e.type && &other != &e)
            m.report.error(other.place,
                           "a second settings element (the first is at line " + std::to_string(e.place.line) + ")",
                           other.name, "one for the whole scene");
    RenderSettings& r = m.scene.render;
    r.width = e.whole("width");
    r.height = e.whole("height");
    r.fps = e.real("fps");
    r.max_depth = e.whole("recursion");
    // The n x n matrix is a Gaussian over the pixel (model.md section 3).
    if (e.whole("interpolate_samples") == 0)
        r.filter.kind = Filter::Kind::point;
    else
        r.filter = {Filter::Kind::gaussian, 0.5, 1.0 / 3};
    const bool lens = e.whole("dof_samples") > 0;
    m.effects = {e.whole("blur_samples") > 0, lens, e.whole("soft_shadow_samples") > 0,
                 e.whole("diffuse_reflection_samples") > 0, e.whole("diffuse_refraction_samples") > 0};
    m.mark("render", e.place);
    const std::pair<const char*, const char*> places[] = {{"width", "width"},
                                                          {"height", "height"},
                                                          {"fps", "fps"},
                                                          {"max_depth", "recursion"},
                                                          {"filter", "interpolate_samples"}};
    for (const auto& [field, attribute] : places) m.mark(std::string("render.") + field, e, attribute);
    map_sample_count(m, e);
    note_dropped_counts(m, e);
    note_effects_off(m, e);
}

void map_legacy_cameras(LegacyMapping& m) {
    const LegacyElement& settings = *find_settings(m);
    std::vector<size_t> cameras;
    for (size_t i = 0; i < m.elements.size(); ++i)
        if (m.elements[i].type->kind == LegacyKind::camera) cameras.push_back(i);
    for (size_t i = 0; i < cameras.size(); ++i)
        map_camera(m, settings, cameras[i], i + 1 < cameras.size() ? &m.elements[cameras[i + 1]] : nullptr);
    const bool uses_fov = std::ranges::any_of(
        cameras, [&](size_t i) { return m.elements[i].given("FOV_start") || m.elements[i].given("FOV_end"); });
    if (uses_fov)
        m.report.note({}, m.options.fov == LegacyOptions::Fov::half_width
                              ? "assumed: angle of view = 2 atan(FOV / 2), the manual's formula (--fov half-width)"
                              : "assumed: angle of view = 2 atan(1 / FOV), FOV the distance of the image plane "
                                "(--fov distance)");
}

}  // namespace drt
