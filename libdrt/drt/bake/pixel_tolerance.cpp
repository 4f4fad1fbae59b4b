#include "drt/bake/pixel_tolerance.h"

#include <algorithm>
#include <limits>

#include "drt/plan/prepare.h"
#include "drt/scene/camera_time.h"

namespace drt {

namespace {

constexpr int views_of_a_camera = 128;

EyeView view_of(const BakeInput& in, const Camera& c, double share) {
    Exposure e;
    if (c.video_end) {
        e.s0 = e.s1 = share;
        e.time0 = e.time1 = scene_time(c, c.video_start + share * (*c.video_end - c.video_start));
    } else {
        e.time0 = e.time1 = in.begin + share * (in.end - in.begin);
    }
    const View<double> v = view_at(build_camera(in.scene.render, c, e), 0.0);
    return {e.time0, v.eye, v.pixel_size};
}

}  // namespace

std::vector<EyeView> eye_views(const BakeInput& in) {
    std::vector<EyeView> out;
    for (const Camera& c : in.scene.cameras)
        for (int i = 0; i < views_of_a_camera; ++i) out.push_back(view_of(in, c, double(i) / (views_of_a_camera - 1)));
    return out;
}

double smallest_pixel(const std::vector<EyeView>& views, const std::function<Vec3d(double time)>& center,
                      double radius) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const EyeView& v : views)
        smallest = std::min(smallest, v.pixel * std::max(length(v.eye - center(v.time)) - radius, radius));
    return smallest;
}

}  // namespace drt
