#include "reference/media.h"

#include <algorithm>
#include <tuple>

#include "drt/base/constants.h"

namespace drt::reference {
namespace {

bool is_closed(const Shape& shape) {
    if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->capped;
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Box>(shape);
}

double volume(const Shape& shape) {
    if (const auto* s = std::get_if<Sphere>(&shape)) return 4 * pi<double> / 3 * s->radius * s->radius * s->radius;
    if (const auto* s = std::get_if<Box>(&shape)) return s->size.x * s->size.y * s->size.z;
    const auto& s = std::get<Cylinder>(shape);
    return pi<double> * s.radius * s.radius * length(s.to - s.from);
}

/// 0 solids, 1 pieces of surfaces, 2 planes.
int extent(const Shape& shape) { return is_closed(shape) ? 0 : std::holds_alternative<Plane>(shape) ? 2 : 1; }

bool outranks(const WorldBody& a, const WorldBody& b) {
    const auto rank = [](const WorldBody& body) { return std::tuple(-body.priority, extent(body.shape)); };
    if (rank(a) != rank(b)) return rank(a) < rank(b);
    if (is_closed(a.shape)) {
        const double va = volume(a.shape), vb = volume(b.shape);
        if (std::abs(va - vb) > 1e-5 * (va + vb)) return va < vb;
    }
    return &a > &b;  // the later in the file
}

bool is_medium(const WorldBody& body) { return !body.light && body.material.refraction > 0 && extent(body.shape) != 1; }

}  // namespace

const WorldBody* owner_of(const Media& media) {
    const auto first = std::min_element(media.begin(), media.end(),
                                        [](const WorldBody* a, const WorldBody* b) { return outranks(*a, *b); });
    return first == media.end() ? nullptr : *first;
}

bool exists(const Media& media, const WorldBody& body, bool entering) {
    const WorldBody* owner = owner_of(media);
    const bool inside = std::find(media.begin(), media.end(), &body) != media.end();
    if (entering) return !owner || outranks(body, *owner);
    return inside ? owner == &body : !owner || outranks(body, *owner);
}

Media beyond(const Media& media, const WorldBody& body, bool entering) {
    Media out = media;
    if (entering)
        out.push_back(&body);
    else if (const auto it = std::find(out.begin(), out.end(), &body); it != out.end())
        out.erase(it);
    return out;
}

/// A ray that starts inside a body leaves it first.
Media media_at(const Instant& instant, const Vec3d& point) {
    Media out;
    const Ray ray{point, normalize(Vec3d{0.36, 0.48, -0.8})};
    for (size_t i = 0; i < instant.poses.size(); ++i) {
        const WorldBody& body = instant.world.bodies[i];
        if (!is_medium(body)) continue;
        const auto hit = hit_body(body, instant.poses[i], ray);
        const auto back = hit_body(body, instant.poses[i], {point, -ray.direction});
        if ((hit && dot(hit->normal, ray.direction) > 0) || (!hit && back && dot(back->normal, ray.direction) < 0))
            out.push_back(&body);
    }
    return out;
}

}  // namespace drt::reference
