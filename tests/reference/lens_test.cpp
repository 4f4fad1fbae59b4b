// Depth of field of a half-plane against the area of a circle's segment (numerics.md C5).

#include "reference/scene_builder.h"

namespace drt {
namespace {

constexpr int spp = 40000;

/// Looks along -z from the origin. A bright half-plane at `distance` along the view covers x > edge; behind it, black.
SceneDesc half_plane(double distance, double edge, const Lens& lens) {
    SceneDesc scene = still_scene({0, 0, 0}, {0, 0, -1});
    scene.cameras[0].lens = lens;
    scene.materials = {glow("bright")};
    scene.bodies = {body(Parallelogram{{edge, -100, -distance}, {100, 0, 0}, {0, 200, 0}}, "bright")};
    return scene;
}

Lens lens_of(double radius, double focus) {
    Lens lens;
    lens.aperture_radius = radius;
    lens.focus_start = focus;
    return lens;
}

/// Share of the unit disc beyond the chord at u: uniform over the area.
double segment(double u) { return (std::acos(u) - u * std::sqrt(1 - u * u)) / std::numbers::pi; }

/// The same with the radius uniform in [0, 1): the mean over the radius of acos(u / radius) / pi, for u > 0.
double radial_segment(double u) { return (std::acos(u) - u * std::acosh(1 / u)) / std::numbers::pi; }

TEST(ReferenceLens, EdgesBlurAsASegmentOfTheLens) {
    Lens lens = lens_of(0.2, 2);
    // At distance 5 the cone of the lens has radius 0.2 * (5 / 2 - 1) = 0.3; at distance 1, 0.1.
    for (const double u : {0.0, 0.3, 0.7}) {
        EXPECT_ESTIMATE(render_pixel(half_plane(5, 0.3 * u, lens), spp), segment(u));
        EXPECT_ESTIMATE(render_pixel(half_plane(1, 0.1 * u, lens), spp), segment(u));
    }
    lens.distribution = Lens::Distribution::radial;
    for (const double u : {0.1, 0.3, 0.7})
        EXPECT_ESTIMATE(render_pixel(half_plane(5, 0.3 * u, lens), spp), radial_segment(u));
}

TEST(ReferenceLens, ImplicitFocusIsTheTarget) {
    SceneDesc scene = half_plane(3, 0.001, lens_of(0.2, 1));
    scene.cameras[0].lens.focus_start.reset();
    scene.cameras[0].targets = {{0, 0, -3}};
    EXPECT_EQ(render_pixel(scene, 100).mean, 0);
    scene.bodies = half_plane(3, -0.001, lens_of(0.2, 1)).bodies;
    EXPECT_EQ(render_pixel(scene, 100).mean, 1);
    scene.cameras[0].targets = {{0, 0, -1}, {0, 0, -5}};  // passes -3 half-way: the focus follows it
    scene.cameras[0].video_end = 2;
    EXPECT_EQ(render_pixel(scene, 100, 1, 25).mean, 1);
    EXPECT_LT(render_pixel(scene, 100, 1, 0).mean, 1);
}

TEST(ReferenceLens, FocusGoesFromStartToEnd) {
    SceneDesc scene = half_plane(3, 0.001, lens_of(0.2, 2));
    scene.cameras[0].lens.focus_end = 4;
    scene.cameras[0].video_end = 2;
    scene.render.fps = 25;
    EXPECT_EQ(render_pixel(scene, 100, 1, 25).mean, 0);  // in focus half-way
    EXPECT_GT(render_pixel(scene, 100, 1, 0).mean, 0);
    EXPECT_GT(render_pixel(scene, 100, 1, 49).mean, 0);
}

TEST(ReferenceLens, ImplicitStartOfTheFocusIsTheFirstTarget) {
    SceneDesc scene = half_plane(3, 0.001, lens_of(0.2, 1));
    Camera& camera = scene.cameras[0];
    camera.lens.focus_start.reset();
    camera.lens.focus_end = 4;
    camera.targets = {{0, 0, -2}, {0, 0, -9}};  // the second does not matter
    camera.video_end = 2;
    scene.render.fps = 25;
    EXPECT_EQ(render_pixel(scene, 100, 1, 25).mean, 0);  // half-way between 2 and 4
    EXPECT_GT(render_pixel(scene, 100, 1, 0).mean, 0);
}

// The left pixel of two, off axis by 45 degrees: what is sharp there tells plane and sphere of focus apart.
TEST(ReferenceLens, FocusSurfaces) {
    const auto left_pixel = [](Lens::FocusSurface surface, double distance, double edge) {
        Lens lens = lens_of(0.1, 2);
        lens.focus_surface = surface;
        SceneDesc scene = half_plane(distance, edge, lens);
        scene.cameras[0].fov_degrees_start = 2 * 180 / std::numbers::pi * std::atan(2.0);  // pixel centres at x = +-1
        return value_of(render_reference(scene, 0, 2, 1, 100, 1)).mean;
    };
    const double h = std::sqrt(2.0);
    EXPECT_EQ(left_pixel(Lens::FocusSurface::plane, 2, -2 - 1e-9), 1);
    EXPECT_EQ(left_pixel(Lens::FocusSurface::plane, 2, -2 + 1e-9), 0);
    EXPECT_EQ(left_pixel(Lens::FocusSurface::sphere, h, -h - 1e-9), 1);
    EXPECT_EQ(left_pixel(Lens::FocusSurface::sphere, h, -h + 1e-9), 0);
}

}  // namespace
}  // namespace drt
