#include "drt/geometry/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace drt {

Bounds unite(const Bounds& a, const Bounds& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {{std::min(a.lower.x, b.lower.x), std::min(a.lower.y, b.lower.y), std::min(a.lower.z, b.lower.z)},
            {std::max(a.upper.x, b.upper.x), std::max(a.upper.y, b.upper.y), std::max(a.upper.z, b.upper.z)}};
}

Bounds around(const Vec3d& center, const Vec3d& half) { return {center - half, center + half}; }

namespace {

Vec3d abs3(const Vec3d& v) { return {std::abs(v.x), std::abs(v.y), std::abs(v.z)}; }
Vec3d max3(const Vec3d& a, const Vec3d& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

// Extents of a disc of radius r with unit normal n: r sqrt(1 - n_i^2) along axis i.
Vec3d disc_extent(const Vec3d& n, double r) {
    const auto e = [&](double c) { return r * std::sqrt(std::max(0.0, 1 - c * c)); };
    return {e(n.x), e(n.y), e(n.z)};
}

}  // namespace

template <class Real>
Vec3d half_extent(const SphereShape<Real>& s) {
    const double r = double(s.radius);
    return {r, r, r};
}

template <class Real>
Vec3d half_extent(const FlatShape<Real>& s) {
    const Vec3d n(s.normal), da(s.da), db(s.db), o(s.origin);
    // The edges are the dual of the dual basis.
    const Vec3d ea = cross(db, n) / dot(cross(db, n), da), eb = cross(n, da) / dot(cross(n, da), db);
    if (s.outline == Outline::disc) return disc_extent(n, length(ea));
    Vec3d e = max3(abs3(o), max3(abs3(o + ea), abs3(o + eb)));
    if (s.outline == Outline::parallelogram) e = max3(e, abs3(o + ea + eb));
    return e;
}

template <class Real>
Vec3d half_extent(const BoxShape<Real>& s) {
    const Vec3d h(s.half);
    return abs3(Vec3d(s.ax)) * h.x + abs3(Vec3d(s.ay)) * h.y + abs3(Vec3d(s.az)) * h.z;
}

template <class Real>
Vec3d half_extent(const CylinderShape<Real>& s) {
    return abs3(Vec3d(s.az)) * double(s.half_height) + disc_extent(Vec3d(s.az), double(s.radius));
}

#define DRT_INSTANTIATE(Real)                             \
    template Vec3d half_extent(const SphereShape<Real>&); \
    template Vec3d half_extent(const FlatShape<Real>&);   \
    template Vec3d half_extent(const BoxShape<Real>&);    \
    template Vec3d half_extent(const CylinderShape<Real>&);
DRT_INSTANTIATE(float)
DRT_INSTANTIATE(double)
#undef DRT_INSTANTIATE

bool turns(std::span<const MotionPiece<double>> pieces) {
    return std::any_of(pieces.begin(), pieces.end(),
                       [](const MotionPiece<double>& p) { return p.angle != 0 || !(p.q0 == Quatd{}); });
}

Vec3d chord_deviation(std::span<const MotionPiece<double>> pieces, double u0, double u1) {
    const Vec3d a = center_at(pieces, u0), b = center_at(pieces, u1);
    const Vec3d slope = (b - a) / (u1 - u0);
    Vec3d worst;
    for (size_t i = 0; i < pieces.size(); ++i) {
        const MotionPiece<double>& p = pieces[i];
        const double end = i + 1 < pieces.size() ? pieces[i + 1].begin : 1.0;
        const double from = std::max(u0, p.begin), to = std::min(u1, end);
        if (from >= to) continue;
        const double h = 1 / p.inv_length;
        const double s_from = (from - p.begin) * p.inv_length, s_to = (to - p.begin) * p.inv_length;
        const auto deviation = [&](double s) {
            const double u = p.begin + s * h;
            return abs3(detail::piece_center(p, s) - (a + slope * (u - u0)));
        };
        worst = max3(worst, max3(deviation(s_from), deviation(s_to)));
        for (int axis = 0; axis < 3; ++axis) {  // 3 c3 s^2 + 2 c2 s + (c1 - slope h) = 0
            const double qa = 3 * component(p.c3, axis), qb = 2 * component(p.c2, axis),
                         qc = component(p.c1, axis) - component(slope, axis) * h;
            std::array<double, 3> roots{-1, -1, -1};
            if (qa != 0) {
                const double disc = std::sqrt(std::max(0.0, qb * qb - 4 * qa * qc));
                roots = {(-qb - disc) / (2 * qa), (-qb + disc) / (2 * qa), -1};
            }
            if (qb != 0) roots[2] = -qc / qb;
            for (const double s : roots)
                if (s > s_from && s < s_to) worst = max3(worst, deviation(s));
        }
    }
    return worst;
}

std::vector<Bounds> bounds_over_time(std::span<const MotionPiece<double>> pieces, const Vec3d& extent, int steps) {
    std::vector<Vec3d> deviation(size_t(steps) - 1);
    const auto at = [&](int i) { return double(i) / (steps - 1); };
    for (int i = 0; i + 1 < steps; ++i) deviation[size_t(i)] = chord_deviation(pieces, at(i), at(i + 1));
    std::vector<Bounds> out;
    for (int i = 0; i < steps; ++i) {
        Vec3d wide;
        if (i > 0) wide = max3(wide, deviation[size_t(i) - 1]);
        if (i + 1 < steps) wide = max3(wide, deviation[size_t(i)]);
        out.push_back(around(center_at(pieces, at(i)), extent + wide));
    }
    return out;
}

int time_steps_for(std::span<const MotionPiece<double>> pieces, const Vec3d& extent) {
    const double size = std::max({extent.x, extent.y, extent.z});
    for (const int steps : {2, 3, 5, 9}) {
        double worst = 0;
        for (int i = 0; i + 1 < steps; ++i) {
            const Vec3d d = chord_deviation(pieces, double(i) / (steps - 1), double(i + 1) / (steps - 1));
            worst = std::max({worst, d.x, d.y, d.z});
        }
        if (worst <= 0.2 * size) return steps;
    }
    return 17;
}

}  // namespace drt
