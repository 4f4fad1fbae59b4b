#pragma once
// How far off a body may be where it is seen: a share of the smallest pixel that it is ever seen in.

#include <functional>

#include "drt/bake/bake_input.h"

namespace drt {

/// A camera's eye at a scene time.
struct EyeView {
    double time = 0;
    Vec3d eye;
    double pixel = 0;  ///< size of a pixel in the picture's middle at distance 1
};

/// All cameras, at as many times of their videos (of the simulated time where a video has no end) as make sure of
/// whatever does not rush past an eye.
std::vector<EyeView> eye_views(const BakeInput&);

/// The smallest of `pixel * distance` over the views, in scene units; the distance is that to the ball of `radius`
/// about the body's centre at the view's time, and no smaller than that radius. Infinite without views.
double smallest_pixel(const std::vector<EyeView>&, const std::function<Vec3d(double time)>& center, double radius);

}  // namespace drt
