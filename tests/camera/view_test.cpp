#include <gtest/gtest.h>

#include <cmath>

#include "drt/base/simd.h"
#include "drt/camera/camera_model.h"

namespace drt {
namespace {

// A Chebyshev series is the same polynomial as its powers, for any number of terms.
TEST(Curve, IsAChebyshevSeries) {
    Curve<double> c;
    for (int n = 1; n <= 300; ++n) {
        c.push_back(1.0 / n);
        for (const double x : {-1.0, -0.3, 0.0, 0.4, 1.0}) {
            double sum = 0;
            for (int k = 0; k < n; ++k) sum += c[size_t(k)] * std::cos(k * std::acos(x));
            EXPECT_NEAR(value_at<double>(c, x), sum, n * 2e-15) << n << " terms, x = " << x;
            EXPECT_NEAR(value_at<float>(cast<float>(c), float(x)), sum, n * 1e-6) << n << " terms, x = " << x;
        }
    }
}

TEST(Curve, OfOneTermIsTheTermItself) { EXPECT_EQ(value_at<Vec3d>(Curve<Vec3d>{{1, 2, 3}}, 0.7), (Vec3d{1, 2, 3})); }

TEST(View, StandsStillOutsideOfItsCurves) {
    CameraModel<double> model;
    model.film = {64, 48};
    model.focus = {3, 1};
    model.begin = 0.25;
    model.inv_length = 4;
    EXPECT_EQ(view_at(model, 0.1).focus, 2);
    EXPECT_EQ(view_at(model, 0.375).focus, 3);
    EXPECT_EQ(view_at(model, 0.8).focus, 4);
}

TEST(View, LanesSeeWhatScalarsSee) {
    CameraModel<double> model;
    model.film = {64, 48};
    model.eye = {{0, 0, 5}, {0.1, 0.2, 0.5}, {0.02, 0, 0.4}};
    model.view = {{0, 0, -5}, {0, 0.1, 0}};
    model.up = {{0, 1, 0}, {0.5, 1, 0}};
    model.pixel_width = {0.01, 0.002, 0.0003};
    model.image_distance = {0.9, -0.01};
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
