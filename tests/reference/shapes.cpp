#include "reference/shapes.h"

#include <stdexcept>

#include "reference/motion.h"

namespace drt::reference {
namespace {

/// Collects the hits of one ray with one shape and keeps the nearest that counts.
struct Intersector {
    const Ray& ray;
    double min_distance;
    std::optional<ShapeHit> nearest;

    void offer(double distance, const Vec3d& normal) {
        if (!(distance > min_distance) || !std::isfinite(distance)) return;
        if (!nearest || distance < nearest->distance) nearest = ShapeHit{distance, normal};
    }
    Vec3d at(double distance) const { return ray.origin + ray.direction * distance; }
    double to_plane(const Vec3d& point, const Vec3d& normal) const {
        return dot(point - ray.origin, normal) / dot(ray.direction, normal);
    }

    void operator()(const Plane& s) { offer(to_plane(s.position, s.normal), normalize(s.normal)); }

    void operator()(const Sphere& s) {
        const Vec3d from_center = ray.origin - s.center;
        const double b = dot(from_center, ray.direction);
        const double c = dot(from_center, from_center) - s.radius * s.radius;
        if (b * b < c) return;
        const double root = std::sqrt(b * b - c);
        for (const double distance : {-b - root, -b + root}) offer(distance, normalize(at(distance) - s.center));
    }

    /// Where the ray meets corner + a edge0 + b edge1, with inside(a, b).
    template <class Inside>
    void flat(const Vec3d& corner, const Vec3d& edge0, const Vec3d& edge1, Inside inside) {
        const Vec3d normal = cross(edge0, edge1);
        const double distance = to_plane(corner, normal);
        const Vec3d q = at(distance) - corner;
        const double a = dot(cross(q, edge1), normal) / dot(normal, normal);
        const double b = dot(cross(edge0, q), normal) / dot(normal, normal);
        if (inside(a, b)) offer(distance, normalize(normal));
    }

    void operator()(const Triangle& s) {
        flat(s.vertex0, s.vertex1 - s.vertex0, s.vertex2 - s.vertex0,
             [](double a, double b) { return a >= 0 && b >= 0 && a + b <= 1; });
    }
    void operator()(const Parallelogram& s) {
        flat(s.corner, s.edge0, s.edge1, [](double a, double b) { return a >= 0 && a <= 1 && b >= 0 && b <= 1; });
    }
    void operator()(const Rectangle& s) { (*this)(Parallelogram{s.vertex0, s.vertex1 - s.vertex0, second_edge(s)}); }

    void operator()(const Box& s) {
        const Quatd turn = normalize(s.orientation);
        const Vec3d half = s.size * 0.5;
        const Vec3d axes[3] = {rotate(turn, Vec3d{1, 0, 0}), rotate(turn, Vec3d{0, 1, 0}),
                               rotate(turn, Vec3d{0, 0, 1})};
        for (int i = 0; i < 3; ++i) {
            for (const double side : {-1.0, 1.0}) {
                const Vec3d normal = axes[i] * side;
                const double distance = to_plane(s.center + normal * component(half, i), normal);
                const Vec3d q = at(distance) - s.center;
                const int j = (i + 1) % 3, k = (i + 2) % 3;
                if (std::abs(dot(q, axes[j])) <= component(half, j) && std::abs(dot(q, axes[k])) <= component(half, k))
                    offer(distance, normal);
            }
        }
    }

    void operator()(const Disc& s) {
        const double distance = to_plane(s.center, s.normal);
        if (length(at(distance) - s.center) <= s.radius) offer(distance, normalize(s.normal));
    }

    void operator()(const Cylinder& s) {
        const double height = length(s.to - s.from);
        const Vec3d axis = (s.to - s.from) / height;
        const auto without_axis = [&](const Vec3d& v) { return v - axis * dot(v, axis); };
        const Vec3d o = without_axis(ray.origin - s.from), d = without_axis(ray.direction);
        const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - s.radius * s.radius;
        if (a > 0 && b * b >= a * c) {
            const double root = std::sqrt(b * b - a * c);
            for (const double distance : {(-b - root) / a, (-b + root) / a}) {
                const Vec3d q = at(distance) - s.from;
                const double up = dot(q, axis);
                if (up >= 0 && up <= height) offer(distance, normalize(without_axis(q)));
            }
        }
        if (!s.capped) return;
        (*this)(Disc{s.from, -axis, s.radius});
        (*this)(Disc{s.to, axis, s.radius});
    }

    void operator()(const SphereSet&) { throw std::invalid_argument("sphere sets are not rendered here"); }
};

/// The horizontal direction of a plane's texture.
Vec3d tangent_of(const Vec3d& unit_normal) {
    const Vec3d helper = std::abs(unit_normal.y) > 0.9 ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
    return normalize(cross(helper, unit_normal));
}

double turns(double y, double x) {
    const double u = std::atan2(y, x) / (2 * std::numbers::pi);
    return u - std::floor(u);
}

/// Texture coordinates before the material's scale, per shape.
struct Mapping {
    Vec3d point, normal;

    Vec2d operator()(const Plane& s) const {
        const Vec3d n = normalize(s.normal), t = tangent_of(n), b = cross(n, t);
        return {dot(point - s.position, t), -dot(point - s.position, b)};
    }
    Vec2d operator()(const Sphere& s) const {
        const Vec3d pole = normalize(s.pole);
        const Vec3d meridian = normalize(s.meridian - pole * dot(s.meridian, pole));
        const Vec3d n = normalize(point - s.center);
        return {turns(dot(n, cross(pole, meridian)), dot(n, meridian)),
                std::acos(std::clamp(dot(n, pole), -1.0, 1.0)) / std::numbers::pi};
    }
    Vec2d operator()(const Rectangle& s) const {
        return {dot(point - s.vertex0, normalize(s.vertex1 - s.vertex0)),
                dot(point - s.vertex0, normalize(second_edge(s)))};
    }
    /// Lengths along the (slanted) edges.
    Vec2d operator()(const Parallelogram& s) const {
        const Vec3d n = cross(s.edge0, s.edge1), q = point - s.corner;
        return {dot(cross(q, s.edge1), n) / dot(n, n) * length(s.edge0),
                dot(cross(s.edge0, q), n) / dot(n, n) * length(s.edge1)};
    }
    /// Faces +-x show (z, y), +-y show (x, z), +-z show (x, y).
    Vec2d operator()(const Box& s) const {
        const Quatd turn = normalize(s.orientation);
        const Vec3d q = rotate_back(turn, point - s.center), n = rotate_back(turn, normal), half = s.size * 0.5;
        if (std::abs(n.x) > 0.5) return {q.z + half.z, half.y - q.y};
        if (std::abs(n.y) > 0.5) return {q.x + half.x, half.z - q.z};
        return {q.x + half.x, half.y - q.y};
    }
    Vec2d operator()(const Cylinder& s) const {
        const double height = length(s.to - s.from);
        const Vec3d axis = (s.to - s.from) / height, x = tangent_of(axis), y = cross(axis, x);
        const Vec3d q = point - s.from;
        if (std::abs(dot(normal, axis)) > 0.5)
            return {0.5 + dot(q, x) / (2 * s.radius), 0.5 - dot(q, y) / (2 * s.radius)};
        return {turns(dot(q, y), dot(q, x)), 1 - dot(q, axis) / height};
    }
    template <class Other>
    Vec2d operator()(const Other&) const {
        throw std::invalid_argument("this shape carries no texture");
    }
};

}  // namespace

std::optional<ShapeHit> intersect(const Shape& shape, const Ray& ray, double min_distance) {
    Intersector intersector{ray, min_distance, {}};
    std::visit(intersector, shape);
    return intersector.nearest;
}

Vec2d texture_coordinates(const Shape& shape, const Vec3d& point, const Vec3d& normal, double scale_u, double scale_v) {
    const Vec2d uv = std::visit(Mapping{point, normal}, shape);
    return {uv.x / scale_u, uv.y / scale_v};
}

}  // namespace drt::reference
