// The step response of every filter: an edge at distance e right of the pixel's centre leaves the filter's integral
// beyond e.

#include "reference/pixel_filter.h"

#include <functional>

#include "reference/scene_builder.h"

namespace drt {
namespace {

constexpr double pi = std::numbers::pi;

/// Bright where x is at least `edge` pixels right of the middle pixel's centre, in a picture of 1 x 1 pixel.
Value step_response(const Filter& filter, double edge) {
    SceneDesc scene = still_scene({0, 0, 1}, {0, 0, 0});
    scene.render.filter = filter;
    const double pixel = 2 * std::tan(22.5 * pi / 180);
    scene.materials = {glow("bright")};
    scene.bodies = {body(Parallelogram{{edge * pixel, -100, 0}, {100, 0, 0}, {0, 200, 0}}, "bright")};
    return render_pixel(scene, 40000);
}

void expect_integral(const Filter& filter, const std::function<double(double)>& cumulative) {
    for (const double edge : {-0.4, 0.1, 0.6, 1.2}) {
        if (edge * 1.01 > filter.radius) continue;
        EXPECT_ESTIMATE(step_response(filter, edge), 1 - cumulative(edge));
    }
}

TEST(ReferenceFilter, Point) {
    EXPECT_EQ(step_response({Filter::Kind::point, 1.5, 0.5}, -0.001).mean, 1);
    EXPECT_EQ(step_response({Filter::Kind::point, 1.5, 0.5}, 0.001).mean, 0);
}

TEST(ReferenceFilter, Box) {
    expect_integral({Filter::Kind::box, 0.5, 0}, [](double x) { return 0.5 + x; });
    expect_integral({Filter::Kind::box, 2, 0}, [](double x) { return 0.5 + x / 4; });
}

TEST(ReferenceFilter, Triangle) {
    expect_integral({Filter::Kind::triangle, 2, 0}, [](double x) {
        const double u = 1 - std::abs(x) / 2, tail = u * u / 2;
        return x < 0 ? tail : 1 - tail;
    });
}

TEST(ReferenceFilter, Gaussian) {
    const double mass = std::erf(1.5 / (0.5 * std::sqrt(2.0)));
    EXPECT_NEAR(mass, 0.997300204, 1e-9);
    expect_integral({Filter::Kind::gaussian, 1.5, 0.5},
                    [&](double x) { return 0.5 + std::erf(x / (0.5 * std::sqrt(2.0))) / (2 * mass); });
}

TEST(ReferenceFilter, BlackmanHarris) {
    expect_integral({Filter::Kind::blackman_harris, 1.5, 0}, [](double x) {
        const double p = pi * (x / 1.5 + 1);
        return (0.35875 * p - 0.48829 * std::sin(p) + 0.07064 * std::sin(2 * p) - 0.01168 / 3 * std::sin(3 * p)) /
               (0.35875 * 2 * pi);
    });
}

// B = C = 1/3 written out: (7|x|^3 - 12x^2 + 16/3) / 6 and (-7/3|x|^3 + 12x^2 - 20|x| + 32/3) / 6, integral 1.
TEST(ReferenceFilter, Mitchell) {
    const auto half = [](double x) {
        const auto inner = [](double t) { return (7 * t * t * t * t / 4 - 4 * t * t * t + 16 * t / 3) / 6; };
        const auto outer = [](double t) {
            return (-7 * t * t * t * t / 12 + 4 * t * t * t - 10 * t * t + 32 * t / 3) / 6;
        };
        return x < 1 ? inner(x) : inner(1) + outer(x) - outer(1);
    };
    EXPECT_NEAR(half(2), 0.5, 1e-12);
    expect_integral({Filter::Kind::mitchell, 2, 0},
                    [&](double x) { return 0.5 + std::copysign(half(std::abs(x)), x); });
    expect_integral({Filter::Kind::mitchell, 1.5, 0},
                    [&](double x) { return 0.5 + std::copysign(half(std::abs(x) * 2 / 1.5), x); });
}

// A constant picture keeps its colour, whatever the filter's weights.
TEST(ReferenceFilter, WeightsAverageToOne) {
    for (const auto kind : {Filter::Kind::box, Filter::Kind::triangle, Filter::Kind::gaussian,
                            Filter::Kind::blackman_harris, Filter::Kind::mitchell}) {
        SceneDesc scene = still_scene({0, 0, 1}, {0, 0, 0});
        scene.background = Color(1.0f);
        scene.render.filter = {kind, 2, 0.5};
        EXPECT_ESTIMATE(render_pixel(scene, 40000), 1);
    }
}

}  // namespace
}  // namespace drt
