#include "reference/lights.h"

#include "reference/shapes.h"

namespace drt::reference {
namespace {

using std::numbers::pi;

struct Sampler {
    const Light& light;
    Vec3d from;
    Random& random;

    bool physical() const { return light.falloff == Light::Falloff::inverse_square; }
    /// `irradiance_per_color`: on a plane that faces the light, from this sample. Without falloff the colour is I_l.
    LightSample sample(const Vec3d& point, double irradiance_per_color) const {
        return {point, Rgb(light.color) * (physical() ? irradiance_per_color / pi : 1.0)};
    }

    std::optional<LightSample> operator()(const PointLight& s) const {
        return sample(s.position, 1 / length_squared(s.position - from));
    }

    /// Uniform over the area. Facing counts only with inverse_square.
    std::optional<LightSample> operator()(const RectLight& s) const {
        const Vec3d point = s.corner + s.edge_x * random.uniform() + s.edge_y * random.uniform();
        const Vec3d area_vector = cross(s.edge_x, s.edge_y), to_light = point - from;
        const double distance = length(to_light);
        double projected_area = -dot(area_vector, to_light) / distance;
        if (physical() && projected_area < 0) {
            if (!s.two_sided) return std::nullopt;
            projected_area = -projected_area;
        }
        return sample(point, projected_area / (distance * distance));
    }

    /// Uniform over all directions: what is seen to shine all around lights from all around.
    std::optional<LightSample> sample_inside(const SphereLight& s) const {
        const double cosine = random.between(-1, 1), azimuth = random.between(0, 2 * pi);
        const double sine = std::sqrt(1 - cosine * cosine);
        const Vec3d direction{sine * std::cos(azimuth), sine * std::sin(azimuth), cosine}, to_center = s.center - from;
        const double along = dot(to_center, direction);
        const double off_axis2 = length_squared(to_center) - along * along;
        const double reach = along + std::sqrt(std::max(0.0, s.radius * s.radius - off_axis2));
        return sample(from + direction * reach, 4 * pi);
    }

    std::optional<LightSample> operator()(const SphereLight& s) const {
        const double distance = length(s.center - from);
        if (distance <= s.radius) return light.visible ? sample_inside(s) : std::nullopt;  // else it shines outwards
        const Vec3d axis = (s.center - from) / distance;
        Vec3d x, y;
        perpendiculars(axis, x, y);
        if (s.distribution == SphereLight::Distribution::radial) {
            const Vec2d p = random.disc(true);
            return sample(s.center + (x * p.x + y * p.y) * s.radius, pi * s.radius * s.radius / (distance * distance));
        }
        // Uniform over the cone of directions that meet the sphere.
        const double sine = s.radius / distance, one_minus_cosine = 1 - std::sqrt(1 - sine * sine);
        const double cosine = 1 - one_minus_cosine * random.uniform(), azimuth = random.between(0, 2 * pi);
        const double sideways = std::sqrt(std::max(0.0, 1 - cosine * cosine));
        const Vec3d direction = axis * cosine + (x * std::cos(azimuth) + y * std::sin(azimuth)) * sideways;
        Sphere sphere;
        sphere.center = s.center;
        sphere.radius = s.radius;
        const auto hit = intersect(sphere, {from, direction}, 0);
        const double reach = hit ? hit->distance : distance * cosine;  // a miss can only be a tangent's rounding
        return sample(from + direction * reach, 2 * pi * one_minus_cosine);
    }
};

}  // namespace

std::optional<LightSample> sample_light(const Light& light, const Vec3d& from, Random& random) {
    return std::visit(Sampler{light, from, random}, light.shape);
}

Rgb emitted(const Light& light, const Vec3d& direction) {
    const auto* rect = std::get_if<RectLight>(&light.shape);
    if (rect && !rect->two_sided && dot(direction, cross(rect->edge_x, rect->edge_y)) > 0) return Rgb(0.0);
    return Rgb(light.color);
}

}  // namespace drt::reference
