#include <gtest/gtest.h>

#include "drt/base/simd.h"
#include "drt/camera/camera_model.h"

namespace drt {
namespace {

Vec3d de_casteljau(std::vector<Vec3d> points, double s) {
    for (; points.size() > 1; points.pop_back())
        for (size_t i = 0; i + 1 < points.size(); ++i) points[i] = points[i] * (1 - s) + points[i + 1] * s;
    return points.front();
}

// Inside the interval and past its end, where an exposure may go.
TEST(Bezier, IsDeCasteljausCurveForEveryDegree) {
    std::vector<Vec3d> points;
    for (int degree = 0; degree <= 7; ++degree) {
        points.push_back({1.0 + degree * degree, 3.0 - degree, degree % 3 - 0.5});
        for (const double s : {0.0, 0.1, 0.5, 0.9, 1.0, 1.2}) {
            const Vec3d difference = bezier(points, s) - de_casteljau(points, s);
            EXPECT_LT(length(difference), 1e-12) << "degree " << degree << ", s " << s;
        }
    }
}

TEST(View, LanesSeeWhatScalarsSee) {
    CameraModel<double> model;
    model.film = {64, 48};
    model.eyes = {{0, 0, 5}, {1, 2, 5}, {2, 0, 4}};
    model.targets = {{0, 0, 0}, {0, 1, 0}};
    model.s0 = 0.2;
    model.s1 = 0.7;
    model.up = {{0, 1, 0}, {0.5, 1, 0}};
    model.fov = {0.8, 1.1};
    model.focus = {2, 3};
    using R = Pack<double>::R;
    const R u([](auto i) { return 0.1 * double(i); });
    const View<R> lanes = view_at(model, u);
    for (int i = 0; i < Pack<double>::width; ++i) {
        const View<double> one = view_at(model, double(u[i]));
        EXPECT_NEAR(lanes.eye.x[i], one.eye.x, 1e-12);
        EXPECT_NEAR(lanes.forward.y[i], one.forward.y, 1e-12);
        EXPECT_NEAR(lanes.right.z[i], one.right.z, 1e-12);
        EXPECT_NEAR(lanes.up.x[i], one.up.x, 1e-12);
        EXPECT_NEAR(lanes.pixel_size[i], one.pixel_size, 1e-7 * one.pixel_size);
        EXPECT_NEAR(lanes.focus[i], one.focus, 1e-12);
    }
}

}  // namespace
}  // namespace drt
