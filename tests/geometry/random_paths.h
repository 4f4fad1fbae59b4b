#pragma once
// Random paths of a few pieces, continuous as build_path makes them, and their slow evaluation.

#include <vector>

#include "drt/geometry/motion_path.h"
#include "random_shapes.h"

namespace drt::test {

inline std::vector<MotionPiece<double>> random_path(Random& r, int pieces, bool turning) {
    std::vector<double> ends{0};
    for (int i = 0; i < pieces; ++i) ends.push_back(ends.back() + r.uniform(0.1, 1));
    std::vector<MotionPiece<double>> path;
    Vec3d from = r.in_box(3);
    Quatd q = r.turn();
    for (int i = 0; i < pieces; ++i) {
        MotionPiece<double> p;
        p.begin = ends[size_t(i)] / ends.back();
        p.inv_length = ends.back() / (ends[size_t(i) + 1] - ends[size_t(i)]);
        p.c0 = from;
        p.c1 = r.in_box(2);
        if (i % 3 != 2) p.c2 = r.in_box(4), p.c3 = r.in_box(4);  // the others are straight
        p.q0 = q;
        p.axis = r.direction();
        p.angle = turning ? r.uniform(-14, 14) : 0;
        from = p.c0 + p.c1 + p.c2 + p.c3;
        if (turning) q = quat_from_axis_angle(p.axis, p.angle) * q;
        path.push_back(p);
    }
    return path;
}

/// The last piece that begins at or before u, by powers and the library's sine.
inline Pose<double> slow_pose(const std::vector<MotionPiece<double>>& path, double u) {
    size_t i = path.size() - 1;
    while (i > 0 && path[i].begin > u) --i;
    const MotionPiece<double>& p = path[i];
    const double s = std::min(1.0, (u - p.begin) * p.inv_length);
    return {p.c0 + p.c1 * s + p.c2 * (s * s) + p.c3 * (s * s * s), quat_from_axis_angle(p.axis, p.angle * s) * p.q0};
}

}  // namespace drt::test
