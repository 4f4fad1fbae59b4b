#pragma once
// Random numbers, turned axes and shapes for the tests of geometry.

#include <cmath>
#include <random>

#include "drt/base/quat.h"
#include "drt/geometry/body_table.h"

namespace drt::test {

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double uniform(double lo, double hi) { return lo + (hi - lo) * (double(engine_()) + 0.5) * 0x1p-64; }
    int below(int n) { return int(engine_() % std::uint64_t(n)); }
    /// A factor between 1 / spread and spread, uniform in its logarithm.
    double scale(double spread) { return std::exp(uniform(-std::log(spread), std::log(spread))); }
    Vec3d in_box(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec3d direction() {
        for (;;) {
            const Vec3d v = in_box(1);
            if (const double r2 = dot(v, v); r2 < 1 && r2 > 1e-4) return normalize(v);
        }
    }
    Quatd turn() { return quat_from_axis_angle(direction(), uniform(0, 6)); }

private:
    std::mt19937_64 engine_;
};

struct Axes {
    Vec3d x, y, z;
};
inline Axes axes_of(const Quatd& q) {
    return {rotate(q, Vec3d{1, 0, 0}), rotate(q, Vec3d{0, 1, 0}), rotate(q, Vec3d{0, 0, 1})};
}

inline FlatShape<double> flat_shape(const Vec3d& origin, const Vec3d& e0, const Vec3d& e1, Outline outline) {
    const Vec3d n = cross(e0, e1);
    return {origin, normalize(n), cross(e1, n) / dot(n, n), cross(n, e0) / dot(n, n), outline};
}

inline constexpr int shape_variety = 8;

/// Of size about 1: sphere, parallelogram, triangle, disc, box, capped and open cylinder, plane.
inline AnyShape random_shape(Random& r, int which) {
    const Axes a = axes_of(r.turn());
    const auto length = [&] { return r.scale(3); };
    switch (which) {
        case 0:
            return SphereShape<double>{length()};
        case 1: {
            const Vec3d e0 = a.x * length(), e1 = a.y * length() + a.x * r.uniform(-0.5, 0.5);
            return flat_shape((e0 + e1) * -0.5, e0, e1, Outline::parallelogram);
        }
        case 2: {
            const Vec3d e0 = a.x * length(), e1 = a.y * length();
            return flat_shape((e0 + e1) / -3.0, e0, e1, Outline::triangle);
        }
        case 3: {
            const double radius = length();
            return flat_shape({}, a.x * radius, a.y * radius, Outline::disc);
        }
        case 4:
            return BoxShape<double>{a.x, a.y, a.z, {length(), length(), length()}};
        case 5:
            return CylinderShape<double>{a.x, a.y, a.z, length(), length(), true};
        case 6:
            return CylinderShape<double>{a.x, a.y, a.z, length(), length(), false};
        default:
            return PlaneShape<double>{a.z};
    }
}

template <class Real>
SphereShape<Real> cast_shape(const SphereShape<double>& s) {
    return {Real(s.radius)};
}
template <class Real>
FlatShape<Real> cast_shape(const FlatShape<double>& s) {
    return {Vec3<Real>(s.origin), Vec3<Real>(s.normal), Vec3<Real>(s.da), Vec3<Real>(s.db), s.outline};
}
template <class Real>
BoxShape<Real> cast_shape(const BoxShape<double>& s) {
    return {Vec3<Real>(s.ax), Vec3<Real>(s.ay), Vec3<Real>(s.az), Vec3<Real>(s.half)};
}
template <class Real>
CylinderShape<Real> cast_shape(const CylinderShape<double>& s) {
    return {Vec3<Real>(s.ax), Vec3<Real>(s.ay), Vec3<Real>(s.az), Real(s.radius), Real(s.half_height), s.capped};
}
template <class Real>
PlaneShape<Real> cast_shape(const PlaneShape<double>& s) {
    return {Vec3<Real>(s.normal)};
}

}  // namespace drt::test
