// Near, many and mirrored lights: pictures of one point against closed forms and quadrature.

#include <gtest/gtest.h>

#include <cmath>

#include "drt/light/light_choice.h"
#include "pictures/scene_kit.h"
#include "sampling/statistics.h"
#include "support/render_picture.h"

namespace drt {
namespace {

using Precision = PlanOptions::Precision;

constexpr int side = 16;

Material white() {
    Material m;
    m.ambient = Color(0.0f);
    m.diffuse = Color(1.0f);
    return m;
}

/// A few pixels of the surface around one point.
SceneDesc look_at(const Vec3d& eye, const Vec3d& target, double fov_degrees) {
    SceneDesc scene = simple_scene(eye, target, fov_degrees);
    scene.render.width = scene.render.height = side;
    scene.render.filter.kind = Filter::Kind::point;
    if (std::abs(normalize(target - eye).y) > 0.99) scene.cameras[0].up_start = {0, 0, 1};
    return scene;
}

/// Mean and spread over the pixels' red values.
test::Mean pixels(const SceneDesc& scene, int spp, Precision precision = Precision::automatic) {
    PlanOptions plan;
    plan.precision = precision;
    RenderOptions options;
    options.spp = spp;
    const Image image = resolve(render_scene(scene, plan, options).film);
    test::Mean mean;
    for (size_t i = 0; i < image.data.size(); i += 4) mean.add(double(image.data[i]));
    return mean;
}

/// Within five standard errors and a relative error `slack`; and a pixel's own error below `noise` of the value.
void expect_pixels(const test::Mean& m, double value, double noise, double slack, const std::string& name) {
    EXPECT_NEAR(m.mean(), value, 5 * std::sqrt(std::max(m.variance(), 0.0) / m.n) + slack * value) << name;
    EXPECT_LT(std::sqrt(std::max(m.variance(), 0.0)), noise * value) << name;
}

// ---- near rectangles -----------------------------------------------------------------------------------------------

TEST(NearLamps, AWhiteFloorUnderACeilingIsAsBrightAsTheCeiling) {
    const struct {
        const char* name;
        RectLight light;
        double expected;
    } cases[] = {
        {"ceiling", {{-1000, 1, -1000}, {2000, 0, 0}, {0, 0, 2000}, false}, 1 - 5e-7},
        {"softbox", {{-1, 0.02, -1}, {2, 0, 0}, {0, 0, 2}, false}, 0.9996728},
        {"softbox, two-sided, the other way round", {{-1, 0.02, -1}, {0, 0, 2}, {2, 0, 0}, true}, 0.9996728},
        {"skewed softbox", {{-1.5, 0.02, -1}, {2, 0, 0}, {1, 0, 2}, false}, 0.9998},
        // A wall of height and half length 1000, 1 away: twice the form factor of its half from below its corner.
        {"wall",
         {{-1000, 0, -1}, {2000, 0, 0}, {0, 1000, 0}, true},
         (std::atan(1000.0) - std::atan(1000 / std::hypot(1, 1000)) / std::hypot(1, 1000)) / pi<double>},
    };
    for (const auto& c : cases) {
        SceneDesc scene = look_at({3, 4, 1}, {0, 0, 0}, 0.01);
        add(scene, "floor", Plane{}, white());
        scene.lights = {light("lamp", c.light, Color(1.0f))};
        for (const Precision precision : {Precision::single, Precision::double_})
            expect_pixels(pixels(scene, 64, precision), c.expected, 0.05, 5e-4, c.name);
    }
}

// ---- many lights ---------------------------------------------------------------------------------------------------

SceneDesc lamps_beside_a_sun(int lamps, double lamp_color, const Vec3d& sun, double sun_color) {
    SceneDesc scene = look_at({0, 40, 0.001}, {0, 0, 0}, 0.0001);
    add(scene, "floor", Plane{}, white());
    for (int i = 0; i < lamps; ++i)
        scene.lights.push_back(
            light("lamp" + std::to_string(i), PointLight{{std::cos(i), 2, std::sin(i)}}, Color(float(lamp_color))));
    scene.lights.push_back(light("sun", PointLight{sun}, Color(float(sun_color))));
    return scene;
}

TEST(ManyLamps, BesideASunAreNotLeftToItsPower) {
    for (const int lamps : {7, few_lights, 40, 1000})
        expect_pixels(pixels(lamps_beside_a_sun(lamps, 5.0 / lamps, {6e4, 8e4, 0}, 1e9), 256), 0.3101698, 0.002, 1e-5,
                      std::to_string(lamps) + " lamps and a far sun");
    for (const int lamps : {8, 40})
        expect_pixels(pixels(lamps_beside_a_sun(lamps, 5.0 / lamps, {60, 80, 0}, 1e4), 256), 0.5393529, 0.002, 1e-5,
                      std::to_string(lamps) + " lamps and a far spot");
}

// The same light in one lamp or cut into many of every size; far ones and hidden ones beside them.
TEST(ManyLamps, ACutUpLampIsAsBrightAsTheWhole) {
    const double whole = 0.2394564705;  // form factor of a square of 2 x 2 at height 2
    for (const int rows : {1, 2, 3, 4, 17, 100}) {
        SceneDesc scene = look_at({0, 1, 0.001}, {0, 0, 0}, 0.01);
        add(scene, "floor", Plane{}, white());
        const double cell = 2.0 / rows;
        for (int i = 0; i < rows * rows; ++i)
            scene.lights.push_back(light(
                "", RectLight{{-1 + cell * (i % rows), 2, -1 + cell * (i / rows)}, {cell, 0, 0}, {0, 0, cell}, false},
                Color(1.0f)));
        for (int i = 0; i < 20; ++i)  // shine away, or are below the floor
            scene.lights.push_back(
                i % 2 == 0 ? light("", RectLight{{double(i), 3, 0}, {0, 0, 1}, {1, 0, 0}, false}, Color(100.0f))
                           : light("", PointLight{{double(i) - 10, -1, 0}}, Color(1e4f)));
        expect_pixels(pixels(scene, 256), whole, 0.05, 1e-4, std::to_string(rows * rows) + " parts");
    }
}

// ---- visible lights ------------------------------------------------------------------------------------------------

TEST(VisibleSpheres, LightWhatIsInside) {
    SceneDesc scene = look_at({0, 3, 1}, {0, 0, 0}, 5);
    add(scene, "floor", Disc{{0, 0, 0}, {0, 1, 0}, 1}, white());
    scene.lights = {light("dome", SphereLight{{0, 0, 0}, 10}, Color(1.0f))};
    scene.lights[0].visible = true;
    expect_pixels(pixels(scene, 256), 1, 0.1, 1e-4, "in the middle");
    std::get<SphereLight>(scene.lights[0].shape).center = {2, 5, -4};
    expect_pixels(pixels(scene, 256), 1, 0.1, 1e-4, "off the middle");
    for (int i = 0; i < few_lights; ++i) {  // by the tree, too
        Light other = scene.lights[0];
        other.visible = false;
        other.shape = PointLight{{0, -5, double(i)}};
        scene.lights.push_back(other);
    }
    expect_pixels(pixels(scene, 256), 1, 0.1, 1e-4, "among others");
}

// The share of a lobe about `axis` that meets the ball of light, its tail below the surface (normal n) mirrored back:
// over the directions to the ball, which are 20 away.
double share_of_lobe(const Vec3d& axis, const Vec3d& n, double sigma, const Vec3d& to_ball, double alpha) {
    double norm = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double theta = (i + 0.5) / steps * pi<double> / 2;
        norm += std::exp(-theta * theta / (2 * sigma * sigma)) * std::cos(theta) * pi<double> / 2 / steps;
    }
    const auto density = [&](const Vec3d& d) {
        const double theta = std::atan2(length(cross(d, axis)), dot(d, axis));
        if (theta >= pi<double> / 2) return 0.0;
        return std::exp(-theta * theta / (2 * sigma * sigma)) * std::cos(theta) /
               (norm * 2 * pi<double> * std::sin(theta));
    };
    const Vec3d x = normalize(cross(to_ball, std::abs(to_ball.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const Vec3d y = cross(to_ball, x);
    double sum = 0;
    constexpr int rings = 1500, sectors = 1501;
    for (int i = 0; i < rings; ++i) {
        const double a = (i + 0.5) / rings * alpha, ring = 2 * pi<double> * std::sin(a) * alpha / rings;
        double mean = 0;
        for (int j = 0; j < sectors; ++j) {
            const double phi = 2 * pi<double> * (j + 0.5) / sectors;
            const Vec3d d = to_ball * std::cos(a) + (x * std::cos(phi) + y * std::sin(phi)) * std::sin(a);
            if (dot(d, n) > 0) mean += density(d) + density(d - n * (2 * dot(d, n)));
        }
        sum += ring * mean / sectors;
    }
    return sum;
}

TEST(GlossyReflections, OfABallOfLightAreTheIntegralOfTheLobe) {
    const struct {
        const char* name;
        double incidence, spread, offset, alpha;  // degrees; offset: of the ball from the mirror direction, upwards
        double noise;                             // of a pixel of 64 samples
    } cases[] = {
        {"ball in a narrow lobe", 40, 2, 2, 1.0, 0.2},
        {"ball as wide as the lobe", 30, 2, 0, 2, 0.15},
        {"small ball, wide lobe", 45, 12, 6, 0.3, 0.12},
        {"tiny ball on the axis", 45, 8, 0.01, 0.05, 0.8},
        {"large ball, narrow lobe", 20, 1, 9, 10, 0.15},
        {"grazing, tail mirrored back", 84, 10, 1, 3, 0.2},
        {"wide lobe, ball cut by the horizon", 70, 30, -20, 8, 0.25},
    };
    for (const auto& c : cases) {
        const double i = radians(c.incidence), out = i - radians(c.offset);
        const Vec3d axis{-std::sin(i), std::cos(i), 0}, to_ball{-std::sin(out), std::cos(out), 0};
        SceneDesc scene = look_at({std::sin(i) * 10, std::cos(i) * 10, 0}, {0, 0, 0}, 1e-3);
        scene.render.max_depth = 1;
        Material m = mirror(0.5, c.spread);
        m.ambient = m.diffuse = m.specular = Color(0.0f);
        add(scene, "mirror", Disc{{0, 0, 0}, {0, 1, 0}, 1}, m);
        scene.lights = {light("ball", SphereLight{to_ball * 20, 20 * std::sin(radians(c.alpha))}, Color(20.0f))};
        scene.lights[0].visible = true;
        const double expected = 10 * share_of_lobe(axis, {0, 1, 0}, radians(c.spread), to_ball, radians(c.alpha));
        for (const Precision precision : {Precision::single, Precision::double_})
            expect_pixels(pixels(scene, 64, precision), expected, c.noise, 5e-3, c.name);
        // Chosen by the tree: as right.
        for (int k = 0; k < few_lights; ++k)
            scene.lights.push_back(light("", PointLight{{5.0 * k - 40, 3, 20}}, Color(1.0f)));
        const test::Mean by_tree = pixels(scene, 256);
        EXPECT_NEAR(by_tree.mean(), expected, 5 * by_tree.error() + 5e-3 * expected) << c.name;
    }
}

}  // namespace
}  // namespace drt
