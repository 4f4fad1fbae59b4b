#include "drt/plan/eye_media.h"

#include <algorithm>

namespace drt {

namespace {

// A cubic leaves its beginning by no more than the sum of its coefficients.
Bounds bounds_of(std::span<const MotionPiece<double>> path, const Vec3d& half) {
    Bounds b;
    for (const MotionPiece<double>& p : path) {
        const auto reach = [](double x, double y, double z) { return std::abs(x) + std::abs(y) + std::abs(z); };
        const Vec3d way{reach(p.c1.x, p.c2.x, p.c3.x), reach(p.c1.y, p.c2.y, p.c3.y), reach(p.c1.z, p.c2.z, p.c3.z)};
        b = unite(b, around(p.c0, half + way));
    }
    return b;
}

// A Chebyshev series leaves its first term by no more than the sum of the others.
Bounds bounds_of_lens(const CameraModel<double>& c) {
    Vec3d half{c.lens.radius, c.lens.radius, c.lens.radius};
    if (!c.path.empty()) return bounds_of(c.path, half);
    for (size_t k = 1; k < c.eye.size(); ++k)
        half += Vec3d{std::abs(c.eye[k].x), std::abs(c.eye[k].y), std::abs(c.eye[k].z)};
    return around(c.eye[0], half);
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
           a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

// Some corner of the lens' bounds is behind it; one that moves may be anywhere.
bool is_behind(const PlaneShape<double>& s, const BodyInput& body, const Bounds& lens) {
    if (!body.path.empty()) return true;
    const Vec3d middle = (lens.lower + lens.upper) * 0.5, half = (lens.upper - lens.lower) * 0.5;
    const double reach = std::abs(s.normal.x) * half.x + std::abs(s.normal.y) * half.y + std::abs(s.normal.z) * half.z;
    return dot(middle - body.center, s.normal) <= reach;
}

bool may_hold(const BodyInput& body, const Bounds& lens) {
    return std::visit(
        [&](const auto& s) {
            using S = std::decay_t<decltype(s)>;
            if constexpr (std::is_same_v<S, FlatShape<double>>) {
                return false;
            } else if constexpr (std::is_same_v<S, PlaneShape<double>>) {
                return is_behind(s, body, lens);
            } else {
                if constexpr (std::is_same_v<S, CylinderShape<double>>)
                    if (!s.capped) return false;
                if (body.path.empty()) return overlap(around(body.center, half_extent(s)), lens);
                const double r = length(half_extent(s));  // however it is turned
                return overlap(bounds_of(body.path, {r, r, r}), lens);
            }
        },
        body.shape);
}

}  // namespace

std::vector<int> find_eye_media(const PreparedScene& p) {
    const Bounds lens = bounds_of_lens(p.camera);
    std::vector<int> out;
    for (size_t i = 0; i < p.bodies.size(); ++i)
        if (p.bodies[i].role.refracts && may_hold(p.bodies[i], lens)) out.push_back(int(i));
    return out;
}

}  // namespace drt
