#include "drt/light/light_bounds.h"

#include <algorithm>
#include <cmath>

namespace drt {
namespace {

Vec3d lower_of(const Vec3d& a, const Vec3d& b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
Vec3d upper_of(const Vec3d& a, const Vec3d& b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

double angle(const Vec3d& a, const Vec3d& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

// A cone about the mean of the axes that holds every cone: not the smallest, but near it where the axes agree.
void unite_cones(LightBounds& out, const LightBounds* first, int count) {
    Vec3d sum;
    for (int i = 0; i < count; ++i) {
        if (first[i].spread >= pi<double> / 2) return;
        sum += first[i].axis;
    }
    if (!(length(sum) > 1e-6)) return;
    out.axis = normalize(sum);
    out.spread = 0;
    for (int i = 0; i < count; ++i) out.spread = std::max(out.spread, angle(out.axis, first[i].axis) + first[i].spread);
}

}  // namespace

LightBounds bounds_of(const PointLightData<double>& l) {
    return {l.position, l.position, {0, 0, 1}, pi<double>, strength(l)};
}

LightBounds bounds_of(const RectLightData<double>& l) {
    const Vec3d a = l.corner, b = a + l.edge_x, c = a + l.edge_y, d = b + l.edge_y;
    return {lower_of(lower_of(a, b), lower_of(c, d)), upper_of(upper_of(a, b), upper_of(c, d)), l.normal,
            l.two_sided ? pi<double> : 0, strength(l)};
}

LightBounds bounds_of(const SphereLightData<double>& l) {
    const Vec3d r{l.radius, l.radius, l.radius};
    return {l.center - r, l.center + r, {0, 0, 1}, pi<double>, strength(l)};
}

LightBounds unite(const LightBounds* first, int count) {
    LightBounds out{first->lower, first->upper, {0, 0, 1}, pi<double>, 0};
    for (int i = 0; i < count; ++i) {
        out.lower = lower_of(out.lower, first[i].lower);
        out.upper = upper_of(out.upper, first[i].upper);
        out.strength += first[i].strength;
    }
    unite_cones(out, first, count);
    return out;
}

}  // namespace drt
