#include "drt/dynamics/clip.h"

#include <algorithm>
#include <limits>

namespace drt {

std::vector<Vec3d> clip(const std::vector<Vec3d>& polygon, const Vec3d& at, const Vec3d& n) {
    const double slack = 1e-9 * length(n);  // corners that lie on each other all count
    std::vector<Vec3d> out;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double dp = dot(p - at, n) - slack, dq = dot(q - at, n) - slack;
        if (dp <= 0) out.push_back(p);
        if ((dp < 0 && dq > 0) || (dp > 0 && dq < 0)) out.push_back(p + (q - p) * (dp / (dp - dq)));
    }
    return out;
}

std::vector<SurfacePoint> spread(std::vector<SurfacePoint> all) {
    std::vector<SurfacePoint> out;
    auto next = std::min_element(all.begin(), all.end(), [](const auto& p, const auto& q) { return p.gap < q.gap; });
    while (next != all.end() && out.size() < most_surface_points) {
        out.push_back(*next);
        all.erase(next);
        const auto distance = [&](const SurfacePoint& p) {
            double least = std::numeric_limits<double>::infinity();
            for (const SurfacePoint& q : out) least = std::min(least, length_squared(p.on_b - q.on_b));
            return least;
        };
        next = std::max_element(all.begin(), all.end(),
                                [&](const auto& p, const auto& q) { return distance(p) < distance(q); });
    }
    return out;
}

}  // namespace drt
