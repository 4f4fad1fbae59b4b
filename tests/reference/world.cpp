#include "reference/world.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace drt::reference {
namespace {

template <class T>
const T& find_by_name(const std::vector<T>& things, const std::string& name) {
    for (const T& thing : things)
        if (thing.name == name) return thing;
    throw std::invalid_argument("nothing is called \"" + name + "\"");
}

std::shared_ptr<const Image> load(const Texture& texture) {
    ReadOptions options;
    if (texture.color_space == Texture::ColorSpace::srgb) options.transfer = ReadOptions::Transfer::srgb;
    if (texture.color_space == Texture::ColorSpace::linear) options.transfer = ReadOptions::Transfer::linear;
    return std::make_shared<Image>(read_image(texture.file, options));
}

std::vector<Shape> spheres_of(const SphereSet& set) {
    std::ifstream file(set.file);
    if (!file) throw std::invalid_argument("cannot read " + set.file);
    std::vector<Shape> spheres;
    for (std::string line; std::getline(file, line);) {
        std::istringstream numbers(line.substr(0, line.find('#')));
        Sphere sphere;
        if (numbers >> sphere.center.x >> sphere.center.y >> sphere.center.z >> sphere.radius)
            spheres.push_back(sphere);
    }
    return spheres;
}

std::optional<Shape> body_of(const LightShape& light) {
    if (const auto* rect = std::get_if<RectLight>(&light))
        return Parallelogram{rect->corner, rect->edge_x, rect->edge_y};
    if (const auto* sphere = std::get_if<SphereLight>(&light)) {
        Sphere body;
        body.center = sphere->center;
        body.radius = sphere->radius;
        return body;
    }
    return std::nullopt;
}

/// The surface that a ray leaves must not be hit again by rounding error.
double skin(const Ray& ray) { return 1e-9 * std::max(1.0, length(ray.origin)); }

}  // namespace

World::World(const SceneDesc& scene_) : scene(scene_) {
    for (const Body& body : scene.bodies) {
        WorldBody resolved;
        resolved.motion = body.motion ? &*body.motion : nullptr;
        resolved.priority = body.priority;
        resolved.material = find_by_name(scene.materials, body.material);
        if (!resolved.material.texture.empty())
            resolved.texture = load(find_by_name(scene.textures, resolved.material.texture));
        const auto* set = std::get_if<SphereSet>(&body.shape);
        for (const Shape& shape : set ? spheres_of(*set) : std::vector<Shape>{body.shape}) {
            resolved.shape = shape;
            bodies.push_back(resolved);
        }
    }
    for (const Light& light : scene.lights) {
        if (!light.visible) continue;
        WorldBody body;
        body.shape = body_of(light.shape).value();
        body.light = &light;
        bodies.push_back(body);
    }
}

Instant::Instant(const World& world_, double time) : world(world_) {
    for (const WorldBody& body : world.bodies) poses.push_back(body.motion ? pose_at(*body.motion, time) : Pose{});
}

std::optional<Hit> hit_body(const WorldBody& body, const Pose& pose, const Ray& ray) {
    if (!body.motion) {
        const auto hit = intersect(body.shape, ray, skin(ray));
        if (!hit) return std::nullopt;
        const Vec3d point = ray.origin + ray.direction * hit->distance;
        return Hit{&body, hit->distance, point, hit->normal, point, hit->normal};
    }
    // Turn and shift the ray instead of the body.
    const Ray described{center_of(body.shape) + rotate_back(pose.orientation, ray.origin - pose.position),
                        rotate_back(pose.orientation, ray.direction)};
    const auto hit = intersect(body.shape, described, skin(ray));
    if (!hit) return std::nullopt;
    return Hit{&body,
               hit->distance,
               ray.origin + ray.direction * hit->distance,
               rotate(pose.orientation, hit->normal),
               described.origin + described.direction * hit->distance,
               hit->normal};
}

std::optional<Hit> first_hit(const Instant& instant, const Ray& ray) {
    std::optional<Hit> nearest;
    for (size_t i = 0; i < instant.poses.size(); ++i) {
        const auto hit = hit_body(instant.world.bodies[i], instant.poses[i], ray);
        if (hit && (!nearest || hit->distance < nearest->distance)) nearest = hit;
    }
    return nearest;
}

bool occluded(const Instant& instant, const Vec3d& from, const Vec3d& to, const Light* light,
              const std::function<bool(const WorldBody&)>& counts) {
    const double distance = length(to - from);
    const Ray ray{from, (to - from) / distance};
    for (size_t i = 0; i < instant.poses.size(); ++i) {
        const WorldBody& body = instant.world.bodies[i];
        if ((body.light && body.light == light) || !counts(body)) continue;
        const auto hit = hit_body(body, instant.poses[i], ray);
        if (hit && hit->distance < distance * (1 - 1e-9)) return true;
    }
    return false;
}

Rgb texture_color(const Hit& hit) {
    const Material& material = hit.body->material;
    const Image& image = *hit.body->texture;
    const Vec2d uv = texture_coordinates(hit.body->shape, hit.described_point, hit.described_normal, material.scale_u,
                                         material.scale_v);
    const double x = (uv.x - std::floor(uv.x)) * image.width - 0.5;
    const double y = (uv.y - std::floor(uv.y)) * image.height - 0.5;
    const int column = int(std::floor(x)), row = int(std::floor(y));
    Rgb sum;
    for (int j = 0; j <= 1; ++j) {
        for (int i = 0; i <= 1; ++i) {
            const double weight = (1 - std::abs(x - (column + i))) * (1 - std::abs(y - (row + j)));
            const float* texel =
                image.pixel((column + i + image.width) % image.width, (row + j + image.height) % image.height);
            sum += Rgb{texel[0], texel[1], texel[2]} * weight;
        }
    }
    return sum;
}

}  // namespace drt::reference
