#include "reference/radiance.h"

#include "drt/base/constants.h"
#include "reference/lights.h"

namespace drt::reference {
namespace {

struct Surface {
    const WorldBody* body;
    Vec3d point;
    Vec3d normal;   ///< unit, faces the ray
    bool entering;  ///< the ray runs against the geometric normal
};

/// A surface that is not there casts no shadow; and no light gets out of the owner that hides it.
bool casts_shadow(const Media& media, const WorldBody& body) {
    const bool transparent = !body.light && body.material.refraction > 0;
    return !transparent || owner_of(media) == &body || exists(media, body, true);
}

Rgb direct_light(const Instant& instant, const Surface& surface, const Ray& ray, const Rgb& diffuse, const Media& media,
                 Random& random) {
    const Material& material = surface.body->material;
    Rgb sum;
    for (const Light& light : instant.world.scene.lights) {
        const auto sample = sample_light(light, surface.point, random);
        if (!sample) continue;
        const Vec3d to_light = normalize(sample->point - surface.point);
        const double cosine = dot(surface.normal, to_light);
        const auto counts = [&](const WorldBody& body) { return casts_shadow(media, body); };
        if (cosine <= 0 || occluded(instant, surface.point, sample->point, &light, counts)) continue;
        const Vec3d mirrored = surface.normal * (2 * cosine) - to_light;
        const double highlight = std::pow(std::max(0.0, -dot(mirrored, ray.direction)), material.shininess);
        sum += sample->intensity * (diffuse * cosine + Rgb(material.specular) * highlight);
    }
    return sum;
}

/// `direction` spread by a glossy lobe and kept on its own side of the surface.
Vec3d spread(const Vec3d& direction, double sigma_degrees, const Vec3d& normal, Random& random) {
    if (sigma_degrees == 0) return direction;
    const double theta = sample_deviation(radians(sigma_degrees), random);
    const double phi = random.between(0, 2 * pi<double>);
    Vec3d x, y;
    perpendiculars(direction, x, y);
    const Vec3d spread = direction * std::cos(theta) + (x * std::cos(phi) + y * std::sin(phi)) * std::sin(theta);
    const double height = dot(spread, normal);
    return height * dot(direction, normal) < 0 ? spread - normal * (2 * height) : spread;
}

Vec3d mirror(const Vec3d& direction, const Vec3d& normal) { return direction - normal * (2 * dot(direction, normal)); }

Rgb reflected(const Instant& instant, const Surface& surface, const Ray& ray, int depth, const Media& media,
              Random& random) {
    const Vec3d direction = spread(mirror(ray.direction, surface.normal),
                                   surface.body->material.reflection_spread_degrees, surface.normal, random);
    return radiance(instant, {surface.point, normalize(direction)}, depth + 1, media, random);
}

double index_of(const WorldBody* medium) { return medium ? medium->material.refraction_index : 1.0; }

Rgb refracted(const Instant& instant, const Surface& surface, const Ray& ray, int depth, const Media& media,
              Random& random) {
    const Material& material = surface.body->material;
    const Media after = beyond(media, *surface.body, surface.entering);
    const WorldBody* left = surface.entering ? owner_of(media) : surface.body;
    const double eta = index_of(left) / index_of(owner_of(after));
    const double c = dot(ray.direction, surface.normal);
    const double sine_squared = eta * eta * (1 - c * c);
    const bool total_reflection = sine_squared > 1;
    const Vec3d sharp = total_reflection
                            ? mirror(ray.direction, surface.normal)
                            : ray.direction * eta - surface.normal * (eta * c + std::sqrt(1 - sine_squared));
    const Vec3d direction = spread(sharp, material.refraction_spread_degrees, surface.normal, random);
    return radiance(instant, {surface.point, normalize(direction)}, depth + 1, total_reflection ? media : after,
                    random);
}

}  // namespace

double sample_deviation(double sigma, Random& random) {
    const double limit = std::min(pi<double> / 2, 9 * sigma);  // beyond 9 sigma the density is below 1e-17
    for (;;) {
        const double theta = random.between(0, limit);
        if (random.uniform() < std::exp(-theta * theta / (2 * sigma * sigma)) * std::cos(theta)) return theta;
    }
}

Rgb radiance(const Instant& instant, const Ray& ray, int depth, const Media& media, Random& random) {
    const auto hit = first_hit(instant, ray);
    if (!hit) return Rgb(instant.world.scene.background);
    if (hit->body->light) return emitted(*hit->body->light, ray.direction);

    const bool entering = dot(ray.direction, hit->normal) < 0;
    if (hit->body->material.refraction > 0 && !exists(media, *hit->body, entering))
        return radiance(instant, {hit->point, ray.direction}, depth, beyond(media, *hit->body, entering), random);
    const Surface surface{hit->body, hit->point, entering ? hit->normal : -hit->normal, entering};
    const Material& material = hit->body->material;
    const bool textured = hit->body->texture != nullptr;
    const Rgb texture = textured ? texture_color(*hit) : Rgb(1.0);
    const Rgb ambient = textured ? texture : Rgb(material.ambient);
    const Rgb diffuse = textured ? texture : Rgb(material.diffuse);

    Rgb sum = Rgb(instant.world.scene.ambient_light) * ambient;
    sum += direct_light(instant, surface, ray, diffuse, media, random);
    if (depth >= instant.world.scene.render.max_depth) return sum;
    if (material.reflectance > 0) sum += reflected(instant, surface, ray, depth, media, random) * material.reflectance;
    if (material.refraction > 0) sum += refracted(instant, surface, ray, depth, media, random) * material.refraction;
    return sum;
}

}  // namespace drt::reference
