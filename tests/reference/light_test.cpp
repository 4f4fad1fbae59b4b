// Light arriving at a white floor, against closed forms (numerics.md L1-L9).

#include <numbers>

#include "reference/scene_builder.h"

namespace drt {
namespace {

using Falloff = Light::Falloff;
constexpr int spp = 100000;

/// One pixel that looks obliquely at the origin of the floor y = 0, whose diffuse colour is 1.
SceneDesc lit_floor(const Light& l, const Vec3d& floor_normal = {0, 1, 0}) {
    SceneDesc scene = still_scene(Vec3d{-3, 0, 0} + floor_normal * 3.0, {0, 0, 0}, {0, 0, 1});
    scene.materials = {matte("white", 1)};
    scene.bodies = {body(Plane{{0, 0, 0}, floor_normal}, "white")};
    scene.lights = {l};
    return scene;
}

RectLight rect_above(double x, double z, double height, double side) {
    RectLight rect;  // shines along cross(edge_x, edge_y) = -y
    rect.corner = {x - side / 2, height, z - side / 2};
    rect.edge_x = {side, 0, 0};
    rect.edge_y = {0, 0, side};
    return rect;
}

SphereLight sphere_at(const Vec3d& center, double radius, SphereLight::Distribution distribution) {
    SphereLight sphere;
    sphere.center = center;
    sphere.radius = radius;
    sphere.distribution = distribution;
    return sphere;
}
constexpr auto uniform = SphereLight::Distribution::uniform;
constexpr auto radial = SphereLight::Distribution::radial;

Vec3d tilted(double degrees) {
    const double t = degrees * std::numbers::pi / 180;
    return {std::sin(t), std::cos(t), 0};
}

TEST(ReferenceLight, RectangleFormFactors) {
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(rect_above(0, 0, 2, 2), 3)), spp), 3 * 0.2394564705);  // L1
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(rect_above(2, 2, 2, 2), 3)), spp), 3 * 0.0395828637);  // L2
}

TEST(ReferenceLight, OneSidedRectangleIsBlackFromBehind) {
    RectLight rect = rect_above(0, 0, 2, 2);
    std::swap(rect.edge_x, rect.edge_y);
    EXPECT_EQ(render_pixel(lit_floor(light(rect, 3)), 100).mean, 0);
    rect.two_sided = true;
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(rect, 3)), spp), 3 * 0.2394564705);
}

TEST(ReferenceLight, SphereFormFactors) {
    const Light sphere = light(sphere_at({0, 2, 0}, 1, uniform), 3);
    EXPECT_ESTIMATE(render_pixel(lit_floor(sphere), spp), 3 * 0.25);
    EXPECT_ESTIMATE(render_pixel(lit_floor(sphere, tilted(45)), spp), 3 * 0.1767766953);  // L4
    EXPECT_ESTIMATE(render_pixel(lit_floor(sphere, tilted(80)), spp), 3 * 0.0546958164);  // L5
}

// Points on the facing disc at radius rho uniform in [0, r), each carrying r^2/d^2: the mean of
// cos = d / sqrt(d^2 + rho^2) is (d/r) asinh(r/d).
TEST(ReferenceLight, RadialSphere) {
    const double mean_cosine = 2 * std::asinh(0.5);
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(sphere_at({0, 2, 0}, 1, radial), 3)), spp), 3 * 0.25 * mean_cosine);
    const Light legacy = light(sphere_at({0, 2, 0}, 1, radial), 3, Falloff::none);
    EXPECT_ESTIMATE(render_pixel(lit_floor(legacy), spp), 3 * mean_cosine);
}

TEST(ReferenceLight, PointLight) {
    const PointLight point{{1, 2, 2}};  // distance 3, cosine 2/3
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(point, 5))), 5 / 9.0 * (2 / 3.0) / std::numbers::pi);
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(point, 5, Falloff::none))), 5 * (2 / 3.0));
}

// Without falloff every point of the light counts alike: the mean of the cosine.
TEST(ReferenceLight, RectangleWithoutFalloffAveragesTheCosine) {
    double mean = 0;
    constexpr int n = 400;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = -1 + 2 * (i + 0.5) / n, z = -1 + 2 * (j + 0.5) / n;
            mean += 2 / std::sqrt(4 + x * x + z * z) / (n * n);
        }
    RectLight rect = rect_above(0, 0, 2, 2);
    std::swap(rect.edge_x, rect.edge_y);  // its facing does not count
    EXPECT_ESTIMATE(render_pixel(lit_floor(light(rect, 3, Falloff::none)), spp), 3 * mean);
}

// Uniform over the cone of half angle 30 degrees: the mean cosine is (1 + cos 30) / 2.
TEST(ReferenceLight, UniformSphereWithoutFalloffAveragesTheCone) {
    const Light sphere = light(sphere_at({0, 2, 0}, 1, uniform), 3, Falloff::none);
    EXPECT_ESTIMATE(render_pixel(lit_floor(sphere), spp), 3 * (1 + std::sqrt(0.75)) / 2);
}

TEST(ReferenceLight, LightsAddUpAndInsideASphereItIsBlack) {
    SceneDesc scene = lit_floor(light(PointLight{{0, 1, 0}}, 1, Falloff::none));
    scene.lights.push_back(light(sphere_at({0, 1, 0}, 2, uniform), 7, Falloff::none));
    scene.lights.push_back(light(sphere_at({0, 1, 0}, 2, radial), 7, Falloff::none));
    scene.lights.push_back(light(PointLight{{0, 3, 0}}, 2, Falloff::none));
    scene.lights.push_back(light(PointLight{{0, -3, 0}}, 100, Falloff::none));  // below the floor
    EXPECT_ESTIMATE(render_pixel(scene), 3);
}

// A strip of width 10 at height 100 above an edge at height 2: a ramp of width 10 * 2 / 98.
TEST(ReferenceLight, PenumbraIsALinearRamp) {
    for (const double share : {0.25, 0.5, 0.75}) {
        SceneDesc scene = lit_floor(light(rect_above(0, 0, 100, 10), 1, Falloff::none));
        scene.materials.push_back(matte("black", 0));
        const double edge = (share - 0.5) * 10 * 2 / 100;  // hides the light's points with x < 50 * edge
        scene.bodies.push_back(body(Parallelogram{{edge - 2, 2, -5}, {2, 0, 0}, {0, 0, 10}}, "black"));
        scene.cameras[0].positions = {{3, 1, 0}};
        const Value value = render_pixel(scene, spp);
        EXPECT_NEAR(value.mean, 1 - share, 4 * value.sigma + 0.001);  // cosines differ from 1 by 1e-3
    }
}

TEST(ReferenceLight, VisibleLightsEmitAndBlock) {
    Light rect = light(rect_above(0, 0, 2, 2), 3);
    rect.visible = true;
    SceneDesc scene = lit_floor(rect);
    EXPECT_ESTIMATE(render_pixel(scene, spp), 3 * 0.2394564705);  // not blocked by its own body
    scene.lights.push_back(light(PointLight{{0, 3, 0}}, 1, Falloff::none));
    EXPECT_ESTIMATE(render_pixel(scene, spp), 3 * 0.2394564705);  // but it blocks others
    scene.cameras[0].positions = {{0, 1, 0}};
    scene.cameras[0].targets = {{0, 2, 0}};
    EXPECT_EQ(render_pixel(scene).mean, 3);
    scene.cameras[0].positions = {{0, 4, 0}};
    EXPECT_EQ(render_pixel(scene).mean, 0);
}

// Legacy points lie inside the bulb: only its own body must let them through.
TEST(ReferenceLight, VisibleRadialSphereIsNotBlockedByItself) {
    Light sphere = light(sphere_at({0, 2, 0}, 1, radial), 3);
    sphere.visible = true;
    EXPECT_ESTIMATE(render_pixel(lit_floor(sphere), spp), 3 * 0.25 * 2 * std::asinh(0.5));
}

// Highlight: mirror of the light about the normal against the direction to the eye.
TEST(ReferenceLight, PhongHighlight) {
    SceneDesc scene = lit_floor(light(PointLight{{4, 3, 0}}, 2, Falloff::none));  // eye towards (-1, 1, 0)
    scene.materials[0].specular = Color(0.5f);
    scene.materials[0].shininess = 10;
    const double cosine = (0.8 + 0.6) / std::sqrt(2.0);
    EXPECT_ESTIMATE(render_pixel(scene), 2 * (0.6 + 0.5 * std::pow(cosine, 10)));
}

}  // namespace
}  // namespace drt
