// Reflection, refraction, glossy lobes and textures, against closed forms.

#include <filesystem>
#include <fstream>
#include <numbers>

#include "reference/scene_builder.h"

namespace drt {
namespace {

constexpr double degree = std::numbers::pi / 180;

Material mirror(double reflectance, double spread_degrees = 0) {
    Material m = matte("mirror", 0);
    m.reflectance = reflectance;
    m.reflection_spread_degrees = spread_degrees;
    return m;
}

Material glass(double index, double spread_degrees = 0) {
    Material m = matte("glass", 0);
    m.refraction = 1;
    m.refraction_index = index;
    m.refraction_spread_degrees = spread_degrees;
    return m;
}

/// Facing up.
Disc disc(const Vec3d& center, double radius) {
    Disc d;
    d.center = center;
    d.radius = radius;
    return d;
}

// M10: two facing mirrors that glow: the geometric series of reflections, cut at max_depth.
TEST(ReferenceMaterial, FacingMirrorsGiveTheGeometricSeries) {
    SceneDesc scene = still_scene({0, 0, 0}, {0.001, 1, 0}, {0, 0, 1});
    Material m = mirror(0.99);
    m.ambient = Color(1.0f);
    scene.materials = {m};
    scene.bodies = {body(Plane{{0, 1, 0}, {0, -1, 0}}, "mirror"), body(Plane{{0, -1, 0}, {0, 1, 0}}, "mirror")};
    for (const int depth : {0, 1, 300}) {
        scene.render.max_depth = depth;
        EXPECT_NEAR(render_pixel(scene).mean, (1 - std::pow(0.99, depth + 1)) / (1 - 0.99), 1e-9);
    }
}

// M4: bodies of index 1 in front of something bright are not there, whatever their shape.
TEST(ReferenceMaterial, IndexOneIsInvisible) {
    SceneDesc scene = still_scene({0.1, 0.2, 5}, {0, 0, 0});
    scene.materials = {glow("wall", 0.5f), glow("spot", 1)};
    scene.bodies = {body(Plane{{0, 0, -2}, {0, 0, 1}}, "wall"), body(Sphere{{0.2, 0, -2}, 0.9}, "spot")};
    const auto without = render_reference(scene, 0, 9, 9, 2, 1);
    scene.materials.push_back(glass(1));
    Sphere outer, inner;
    outer.radius = 2;
    inner.radius = 1;
    outer.center = inner.center = {0, 0, 1};
    scene.bodies.push_back(body(outer, "glass"));
    scene.bodies.push_back(body(inner, "glass"));
    scene.bodies.push_back(body(Cylinder{{-1, -1, 1}, {1, 0.3, 1}, 0.4, true}, "glass"));
    scene.bodies.push_back(body(Disc{{0, 0, 3.5}, {0, 0.2, 1}, 3}, "glass"));
    EXPECT_EQ(without.mean, render_reference(scene, 0, 9, 9, 2, 1).mean);
}

// From inside glass of index 1.5, M6: out below the critical angle of 41.810315 degrees, mirrored above it.
TEST(ReferenceMaterial, TotalInternalReflection) {
    const auto looking_up_at = [](double degrees) {
        const double t = degrees * degree;
        SceneDesc scene = still_scene({0, 0, 0}, {std::sin(t), std::cos(t), 0}, {0, 0, 1});
        scene.materials = {glass(1.5), glow("inside", 0.25f)};
        Box box;
        box.size = {20, 2, 20};
        scene.bodies = {body(box, "glass"), body(Plane{{0, -0.9, 0}, {0, 1, 0}}, "inside")};
        scene.background = Color(1.0f);
        return render_pixel(scene).mean;
    };
    EXPECT_EQ(looking_up_at(41.810), 1);
    EXPECT_EQ(looking_up_at(41.811), 0.25);
}

// Snell twice, down through a pool and a block inside it: the ray must pass the bright disc's edge on the right side.
TEST(ReferenceMaterial, RefractionFollowsSnellAndTheMediaStack) {
    const auto through = [](double radius) {
        SceneDesc scene = still_scene({-1, 1, 0}, {0, 0, 0});  // 45 degrees
        Material diamond = glass(2.4), water = glass(1.3);
        diamond.name = "diamond";
        water.name = "water";
        scene.materials = {glow("spot"), diamond, water};
        Box pool, block;
        pool.center = {0, -5, 0};
        pool.size = {40, 10, 40};
        block.center = {0, -5, 0};  // inside the pool, top at y = -1
        block.size = {30, 8, 30};
        const double in_water = std::asin(std::sqrt(0.5) / 1.3), in_diamond = std::asin(std::sqrt(0.5) / 2.4);
        const double x = std::tan(in_water) + std::tan(in_diamond);  // at y = -2
        scene.bodies = {body(pool, "water"), body(block, "diamond"), body(disc({x - 1 + radius, -2, 0}, 1), "spot")};
        return render_pixel(scene).mean;
    };
    EXPECT_EQ(through(0.001), 1);
    EXPECT_EQ(through(-0.001), 0);
}

/// Share of the lobe's deviations below `theta`: the integral of exp(-t^2/2s^2) cos t, by the midpoint rule.
double lobe_share(double sigma_degrees, double theta) {
    const double sigma = sigma_degrees * degree;
    const auto integral = [&](double limit) {
        double sum = 0;
        constexpr int n = 100000;
        for (int i = 0; i < n; ++i) {
            const double t = limit * (i + 0.5) / n;
            sum += std::exp(-t * t / (2 * sigma * sigma)) * std::cos(t) * limit / n;
        }
        return sum;
    };
    return integral(theta) / integral(std::numbers::pi / 2);
}

TEST(ReferenceMaterial, GlossyLobesHaveTheStatedDensity) {
    for (const double sigma : {2.0, 20.0, 170.0}) {
        for (const double share : {0.3, 1.0, 2.0}) {
            const double theta = std::min(share * sigma, 60.0) * degree;
            SceneDesc scene = still_scene({0, 0.5, 0}, {0, 0, 0}, {0, 0, 1});
            scene.materials = {mirror(1, sigma), glow("spot")};
            scene.bodies = {body(Plane{}, "mirror"), body(disc({0, 1, 0}, std::tan(theta)), "spot")};
            EXPECT_ESTIMATE(render_pixel(scene, 20000), lobe_share(sigma, theta));
            scene.materials[0] = glass(1, sigma);
            scene.materials[0].name = "mirror";
            scene.bodies[1] = body(disc({0, -1, 0}, std::tan(theta)), "spot");
            EXPECT_ESTIMATE(render_pixel(scene, 20000), lobe_share(sigma, theta));
        }
    }
}

// Grazing and wide: whatever would go below the surface comes out above it.
TEST(ReferenceMaterial, GlossyDirectionsStayOnTheirSide) {
    SceneDesc scene = still_scene({-5, 0.5, 0}, {0, 0, 0});
    scene.materials = {mirror(1, 60)};
    scene.bodies = {body(disc({0, 0, 0}, 1), "mirror")};
    scene.materials.push_back(glow("above"));
    Sphere dome;
    dome.radius = 100;
    scene.bodies.push_back(body(dome, "above"));
    scene.materials.push_back(matte("below", 0));
    scene.bodies.push_back(body(Plane{{0, -1e-6, 0}, {0, 1, 0}}, "below"));
    EXPECT_EQ(render_pixel(scene, 2000).mean, 1);
}

TEST(ReferenceMaterial, ReflectedAndRefractedSharesAddUp) {
    SceneDesc scene = still_scene({0, 1, 0}, {0, 0, 0}, {0, 0, 1});
    Material m = glass(1.5);
    m.reflectance = 0.25;
    m.refraction = 0.5;
    m.ambient = Color(0.125f);
    scene.materials = {m, glow("below", 3)};
    scene.background = Color(2.0f);
    scene.bodies = {body(disc({0, 0, 0}, 5), "glass"), body(Plane{{0, -1, 0}, {0, 1, 0}}, "below")};
    EXPECT_DOUBLE_EQ(render_pixel(scene).mean, 0.125 + 0.25 * 2 + 0.5 * 3);
}

/// A 4 x 2 texture file whose texel in column x, row y has the linear red value (1 + x + 4 y) / 255.
std::string write_texture() {
    const auto path =
        std::filesystem::path(::testing::TempDir()) /
        ("reference_texture_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + ".ppm");
    std::ofstream file(path, std::ios::binary);
    file << "P6\n4 2\n255\n";
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 4; ++x) file << char(1 + x + 4 * y) << '\0' << '\0';
    return path.string();
}

/// 255 times the red seen at `target` of a textured shape, looking along -normal.
double texel_at(const Shape& shape, const Vec3d& target, const Vec3d& normal, double scale_u = 1, double scale_v = 1) {
    SceneDesc scene = still_scene(target + normal, target, Vec3d{normal.y, normal.z, normal.x});
    Material m = matte("textured", 0);
    m.texture = "map";
    m.scale_u = scale_u;
    m.scale_v = scale_v;
    scene.materials = {m};
    scene.textures = {Texture{"map", write_texture(), Texture::ColorSpace::linear}};
    scene.bodies = {body(shape, "textured")};
    return render_pixel(scene).mean * 255;
}

constexpr double tolerance = 1e-4;

TEST(ReferenceTexture, PlanarMappings) {
    // Floor: t = cross((0, 0, 1), y) = -x, b = cross(n, t) = z; u = -x, v = -z.
    EXPECT_NEAR(texel_at(Plane{}, {-0.125, 0, -0.25}, {0, 1, 0}), 1, tolerance);
    EXPECT_NEAR(texel_at(Plane{}, {-0.375, 0, -0.25}, {0, 1, 0}), 2, tolerance);
    EXPECT_NEAR(texel_at(Plane{}, {-0.125, 0, -0.75}, {0, 1, 0}), 5, tolerance);
    EXPECT_NEAR(texel_at(Plane{}, {-1.25, 0, 7.25}, {0, 1, 0}, 10, 1), 5, tolerance);  // repeats
    EXPECT_NEAR(texel_at(Plane{}, {-0.25, 0, -0.25}, {0, 1, 0}), 1.5, tolerance);      // bilinear
    EXPECT_NEAR(texel_at(Plane{}, {0, 0, -0.25}, {0, 1, 0}), 2.5, tolerance);          // across the seam: 4 and 1
    // Wall facing z: t = x, b = y; u = x, v = -y.
    EXPECT_NEAR(texel_at(Plane{{0, 0, 0}, {0, 0, 2}}, {0.375, -0.25, 0}, {0, 0, 1}), 2, tolerance);
    const Rectangle rectangle{{1, 0, 0}, {3, 0, 0}, {2.5, 1, 0}};
    EXPECT_NEAR(texel_at(rectangle, {1.375, 0.75, 0}, {0, 0, 1}), 6, tolerance);
    const Parallelogram slanted{{0, 0, 0}, {1, 0, 0}, {3, 4, 0}};                              // edge lengths 1 and 5
    EXPECT_NEAR(texel_at(slanted, {0.375 + 0.15 * 3, 0.15 * 4, 0}, {0, 0, 1}), 6, tolerance);  // v = 0.75
}

TEST(ReferenceTexture, SphereBoxAndCylinder) {
    const double h = std::sqrt(0.5);
    const Sphere sphere;                                                      // pole y, meridian z, b = cross(y, z) = x
    EXPECT_NEAR(texel_at(sphere, {0, 1 * h, h}, {0, h, h}), 2.5, tolerance);  // u = 0: between 4 and 1
    EXPECT_NEAR(texel_at(sphere, {0.5, h, 0.5}, {0.5, h, 0.5}), 1, tolerance);            // u = 1/8, v = 1/4
    EXPECT_NEAR(texel_at(sphere, {0.5, -h, -0.5}, {0.5, -h, -0.5}), 6, tolerance);        // u = 3/8, v = 3/4
    EXPECT_NEAR(texel_at(sphere, {0.5, h, 0.5}, {0.5, h, 0.5}, 0.5, 1), 1.5, tolerance);  // u = 1/4
    Box box;
    box.center = {5, 0, 0};
    box.size = {2, 1, 3};
    EXPECT_NEAR(texel_at(box, {6, 0.25, -1.125}, {1, 0, 0}), 2, tolerance);   // u = z + 1.5
    EXPECT_NEAR(texel_at(box, {4.375, 0.5, 0.75}, {0, 1, 0}), 6, tolerance);  // v = 1.5 - z
    EXPECT_NEAR(texel_at(box, {4.375, -0.25, -1.5}, {0, 0, -1}), 6, tolerance);
    const Cylinder cylinder{{0, 0, 0}, {0, 2, 0}, 1, true};                   // x = -x, y = cross(y, -x) = z
    EXPECT_NEAR(texel_at(cylinder, {-h, 1.5, h}, {-h, 0, h}), 1, tolerance);  // azimuth 45 degrees, v = 1/4
    EXPECT_NEAR(texel_at(cylinder, {h, 0.5, h}, {h, 0, h}), 6, tolerance);
    EXPECT_NEAR(texel_at(cylinder, {0.25, 2, -0.5}, {0, 1, 0}), 6, tolerance);  // cap: u = 0.5 - 0.125, v = 0.75
}

// The texture replaces the diffuse and the ambient colour.
TEST(ReferenceTexture, TakesTheColoursPlaces) {
    SceneDesc scene = still_scene({-0.125, 1, -0.25}, {-0.125, 0, -0.25}, {0, 0, 1});
    Material m = matte("textured", 1);
    m.texture = "map";
    scene.materials = {m};
    scene.textures = {Texture{"map", write_texture(), Texture::ColorSpace::linear}};
    scene.bodies = {body(Plane{}, "textured")};
    scene.ambient_light = Color(0.5f);
    scene.lights = {light(PointLight{{-0.125, 3, -0.25}}, 2, Light::Falloff::none)};
    EXPECT_NEAR(render_pixel(scene).mean * 255, 0.5 + 2, tolerance);
}

}  // namespace
}  // namespace drt
