// Lights: drt's extension of the format (the manual's page on them is lost).
#include <algorithm>

#include "drt/formats/legacy_map.h"

namespace drt {
namespace {

LightShape map_shape(LegacyMapping& m, const LegacyElement& e, const std::string& path) {
    const Vec3d position = e.vector("position");
    if (e.type->kind == LegacyKind::light_rect) {
        const Vec3d x = e.vector("x"), y = e.vector("y");
        if (!m.effects.soft_shadows) return PointLight{position + x * 0.5 + y * 0.5};
        m.mark(path + ".corner", e, "position");
        m.mark(path + ".edge_x", e, "x");
        m.mark(path + ".edge_y", e, "y");
        return RectLight{.corner = position, .edge_x = x, .edge_y = y};
    }
    if (e.type->kind == LegacyKind::light_bulb && m.effects.soft_shadows) {
        m.mark(path + ".center", e, "position");
        m.mark(path + ".radius", e, "radius");
        return SphereLight{position, e.real("radius"), SphereLight::Distribution::radial};
    }
    m.mark(path + ".position", e, "position");
    return PointLight{position};
}

void map_light(LegacyMapping& m, size_t index) {
    const LegacyElement& e = m.elements[index];
    const std::string path = "lights[" + std::to_string(m.scene.lights.size()) + ']';
    const Vec3d c = e.vector("color");
    m.mark(path, e.place);
    m.mark(path + ".name", e.name_place);
    m.mark(path + ".color", e, "color");
    Light light;
    light.name = m.names.name(index);
    light.shape = map_shape(m, e, path);
    light.color = {float(c.x), float(c.y), float(c.z)};
    light.falloff = Light::Falloff::none;
    if (light.name != e.name) m.report.note(e.name_place, "renamed to " + light.name + ": another light has this name");
    m.scene.lights.push_back(std::move(light));
}

/// A white bulb up and to the left of the first camera, half as far from it as its target: off the view's axis, so
/// that bodies show their form and cast shadows that the camera sees.
void add_default_light(LegacyMapping& m) {
    Vec3d eye{0, 0, 5}, target, up{0, 1, 0};
    if (!m.scene.cameras.empty()) {
        const Camera& c = m.scene.cameras.front();
        eye = c.positions.front();
        target = c.targets.front();
        up = c.up_start;
    }
    const Vec3d view = target - eye;
    const Vec3d left = cross(up, view);
    const double distance = length(view);
    // A camera without a view is reported by validate(); the light only has to be finite then.
    const bool sound = distance > 0 && length(left) > 0;
    const Vec3d offset = sound ? normalize(up) * (distance / 2) + normalize(left) * (distance / 2) : Vec3d{0, 10, 0};
    const double radius = sound ? distance / 20 : 0.5;
    Light light;
    light.name = "added_light";
    if (m.effects.soft_shadows)
        light.shape = SphereLight{eye + offset, radius, SphereLight::Distribution::radial};
    else
        light.shape = PointLight{eye + offset};
    light.falloff = Light::Falloff::none;
    m.scene.lights.push_back(std::move(light));
    m.report.note({}, "added a white bulb light up and to the left of the first camera (--add-lights)");
}

}  // namespace

void map_legacy_lights(LegacyMapping& m) {
    for (size_t i = 0; i < m.elements.size(); ++i) {
        const LegacyKind kind = m.elements[i].type->kind;
        if (kind == LegacyKind::light_point || kind == LegacyKind::light_rect || kind == LegacyKind::light_bulb)
            map_light(m, i);
    }
    if (!m.scene.lights.empty()) return;
    if (m.options.add_lights) return add_default_light(m);
    m.report.warning({}, "the scene has no lights: it shows its ambient light only (--add-lights adds one)");
}

}  // namespace drt
