#pragma once
// What a camera does over its video interval -> curves over the part of it that one exposure shows.

#include <vector>

#include "drt/camera/curve.h"

namespace drt {

/// Shares of the camera's video interval.
struct Stretch {
    double from = 0, to = 0;
};

/// Goes linearly from `start` at share 0 to `end` at share 1.
template <class V>
Curve<V> linear_curve(const V& start, const V& end, const Stretch& s) {
    const V step = end - start, a = start + step * s.from, b = start + step * s.to;
    if (a == b) return {a};
    return {(a + b) * 0.5, (b - a) * 0.5};
}

/// The Bezier curve with these control points, exact to the rounding of their differences however many they are.
Curve<Vec3d> bezier_curve(const std::vector<Vec3d>& points, const Stretch&);

/// A point of a Bezier curve, s in [0, 1].
Vec3d bezier_point(const std::vector<Vec3d>& points, double s);

/// sin and cos of an angle in [0, pi / 2] that goes linearly.
Curve<double> sine_curve(double start, double end, const Stretch&);
Curve<double> cosine_curve(double start, double end, const Stretch&);

}  // namespace drt
