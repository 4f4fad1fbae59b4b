#include "exact_shapes.h"

#include <algorithm>
#include <cmath>

namespace drt::test {
namespace {

using QuadVec = Vec3<Quad>;

// Newton's step doubles the digits of the hardware's root.
Quad root(Quad x) {
    if (x <= 0) return 0;
    const Quad r = std::sqrt((long double)(x));
    return (r + x / r) / 2;
}

Quad magnitude(Quad x) { return x < 0 ? -x : x; }

template <class Real>
QuadVec quad(const Vec3<Real>& v) {
    return {Quad(v.x), Quad(v.y), Quad(v.z)};
}

Vec3d unit(const QuadVec& v) {
    const Quad r = root(dot(v, v));
    return {double(v.x / r), double(v.y / r), double(v.z / r)};
}

Crossing crossing(Quad t, int part, const Ray& ray, const QuadVec& normal) {
    const Vec3d n = unit(normal);
    return {t, part, std::abs(dot(n, unit(ray.d))), n};
}

std::vector<Crossing> sorted(std::vector<Crossing> c) {
    std::sort(c.begin(), c.end(), [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    return c;
}

// Roots of a t^2 + 2 b t + c.
std::vector<Quad> quadratic(Quad a, Quad b, Quad c) {
    const Quad d = b * b - a * c;
    if (d < 0 || a == 0) return {};
    return {(-b - root(d)) / a, (-b + root(d)) / a};
}

}  // namespace

template <class Real>
std::vector<Crossing> crossings(const SphereShape<Real>& s, const Ray& ray, const Vec3d& grow) {
    const Quad r = Quad(s.radius) + grow.x;
    std::vector<Crossing> out;
    for (const Quad t : quadratic(dot(ray.d, ray.d), dot(ray.o, ray.d), dot(ray.o, ray.o) - r * r))
        out.push_back(crossing(t, 0, ray, ray.o + ray.d * t));
    return out;
}

template <class Real>
std::vector<Crossing> crossings(const FlatShape<Real>& s, const Ray& ray, const Vec3d& grow) {
    const QuadVec n = quad(s.normal), da = quad(s.da), db = quad(s.db);
    const Quad dn = dot(ray.d, n);
    if (dn == 0) return {};
    const Quad t = dot(quad(s.origin) - ray.o, n) / dn;
    const QuadVec q = ray.o + ray.d * t - quad(s.origin);
    const Quad a = dot(q, da), b = dot(q, db);
    const Quad ga = root(dot(da, da)) * grow.x, gb = root(dot(db, db)) * grow.x, g = ga + gb;
    const bool inside = s.outline == Outline::disc       ? root(a * a + b * b) <= 1 + g
                        : s.outline == Outline::triangle ? a >= -ga && b >= -gb && a + b <= 1 + g
                                                         : a >= -ga && b >= -gb && a <= 1 + ga && b <= 1 + gb;
    if (!inside) return {};
    return {crossing(t, 0, ray, n)};
}

template <class Real>
std::vector<Crossing> crossings(const BoxShape<Real>& s, const Ray& ray, const Vec3d& grow) {
    const QuadVec axes[3] = {quad(s.ax), quad(s.ay), quad(s.az)};
    Quad half[3], o[3], d[3];
    for (int i = 0; i < 3; ++i) {
        half[i] = Quad(component(s.half, i)) + component(grow, i);
        o[i] = dot(ray.o, axes[i]);
        d[i] = dot(ray.d, axes[i]);
    }
    // Face by face: where is the face's plane met, and is that within the face?
    std::vector<Crossing> out;
    for (int face = 0; face < 6; ++face) {
        const int i = face / 2, j = (i + 1) % 3, k = (i + 2) % 3;
        if (d[i] == 0) continue;
        const Quad side = face % 2 == 0 ? 1 : -1;
        const Quad t = (side * half[i] - o[i]) / d[i];
        if (magnitude(o[j] + d[j] * t) > half[j] || magnitude(o[k] + d[k] * t) > half[k]) continue;
        out.push_back(crossing(t, face, ray, axes[i] * side));
    }
    return sorted(out);
}

template <class Real>
std::vector<Crossing> crossings(const CylinderShape<Real>& s, const Ray& ray, const Vec3d& grow) {
    const QuadVec ax = quad(s.ax), ay = quad(s.ay), az = quad(s.az);
    const Quad r = Quad(s.radius) + grow.x, h = Quad(s.half_height) + grow.z;
    const Quad ox = dot(ray.o, ax), oy = dot(ray.o, ay), oz = dot(ray.o, az);
    const Quad dx = dot(ray.d, ax), dy = dot(ray.d, ay), dz = dot(ray.d, az);
    std::vector<Crossing> out;
    for (const Quad t : quadratic(dx * dx + dy * dy, ox * dx + oy * dy, ox * ox + oy * oy - r * r))
        if (magnitude(oz + dz * t) <= h)
            out.push_back(crossing(t, part_side, ray, ax * (ox + dx * t) + ay * (oy + dy * t)));
    if (s.capped && dz != 0)
        for (const int part : {int(part_top), int(part_bottom)}) {
            const Quad side = part == part_top ? 1 : -1;
            const Quad t = (side * h - oz) / dz;
            const Quad x = ox + dx * t, y = oy + dy * t;
            if (x * x + y * y <= r * r) out.push_back(crossing(t, part, ray, az * side));
        }
    return sorted(out);
}

template <class Real>
std::vector<Crossing> crossings(const PlaneShape<Real>& s, const Ray& ray, const Vec3d&) {
    const QuadVec n = quad(s.normal);
    const Quad dn = dot(ray.d, n);
    if (dn == 0) return {};
    return {crossing(-dot(ray.o, n) / dn, 0, ray, n)};
}

#define DRT_INSTANTIATE(Real)                                                                            \
    template std::vector<Crossing> crossings(const SphereShape<Real>&, const Ray&, const Vec3d& grow);   \
    template std::vector<Crossing> crossings(const FlatShape<Real>&, const Ray&, const Vec3d& grow);     \
    template std::vector<Crossing> crossings(const BoxShape<Real>&, const Ray&, const Vec3d& grow);      \
    template std::vector<Crossing> crossings(const CylinderShape<Real>&, const Ray&, const Vec3d& grow); \
    template std::vector<Crossing> crossings(const PlaneShape<Real>&, const Ray&, const Vec3d& grow);
DRT_INSTANTIATE(float)
DRT_INSTANTIATE(double)
#undef DRT_INSTANTIATE

}  // namespace drt::test
