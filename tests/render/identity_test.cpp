// Scenes that must give the same picture though they are described or placed differently.

#include <gtest/gtest.h>

#include <cmath>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"
#include "support/transform_scene.h"

namespace drt {
namespace {

Film film_of(const SceneDesc& scene, int frame = 0, int spp = 4) {
    PlanOptions plan;
    plan.frame = frame;
    RenderOptions options;
    options.spp = spp;
    return render_scene(scene, plan, options).film;
}

/// Share of pixels that differ by more than `tolerance` in some channel, relative to the brighter one where it is
/// above 1.
double share_of_different_pixels(const Film& a, const Film& b, double tolerance) {
    const Image p = resolve(a), q = resolve(b);
    int different = 0;
    for (size_t i = 0; i < p.data.size(); i += 4) {
        bool differs = false;
        for (size_t c = i; c < i + 4; ++c)
            differs |= !(std::abs(p.data[c] - q.data[c]) <= tolerance * std::max(1.0f, std::abs(p.data[c])));
        different += differs;
    }
    return different / (double(p.data.size()) / 4);
}

TEST(Identity, AnInstantaneousShutterSeesBodiesWhereTheyAre) {
    PictureCase picture = find_picture("motion blur", ::testing::TempDir());
    SceneDesc& moving = picture.scene;
    moving.bodies.resize(4);  // those of the row: none is turned
    moving.bodies[3].motion.reset();
    moving.bodies[1].motion = Motion{Motion::Interpolation::linear, {key(0, {-1, 0.5, 2}), key(0.25, {0, 1, 2})}};
    moving.cameras[0].shutter.duration = 0;
    moving.cameras[0].time_start = 0.125;
    SceneDesc still = moving;
    still.bodies[1].motion.reset();
    std::get<Sphere>(still.bodies[1].shape).center = {-0.5, 0.75, 2};
    EXPECT_TRUE(same_bits(film_of(moving), film_of(still)));
}

TEST(Identity, AnOpenShutterBeforeStandingBodiesIsNone) {
    SceneDesc still = find_picture("shapes", ::testing::TempDir()).scene;
    SceneDesc open = still;
    open.cameras[0].shutter = {0.5, 0.4};
    open.bodies[1].motion = Motion{Motion::Interpolation::cubic, {key(0, {-2.6, 0.8, 0}), key(1, {-2.6, 0.8, 0})}};
    EXPECT_TRUE(same_bits(film_of(still), film_of(open)));
}

TEST(Identity, ALensWithoutApertureIsAPinhole) {
    SceneDesc pinhole = find_picture("shapes", ::testing::TempDir()).scene;
    SceneDesc lens = pinhole;
    lens.cameras[0].lens.focus_start = 3;
    lens.cameras[0].lens.focus_end = 5;
    lens.cameras[0].lens.distribution = Lens::Distribution::radial;
    lens.cameras[0].lens.focus_surface = Lens::FocusSurface::sphere;
    EXPECT_TRUE(same_bits(film_of(pinhole), film_of(lens)));
}

// Coordinates are taken relative to the eye in double before anything is rounded: what moves with the eye stays. The
// shift itself rounds coordinates by 1e-10, which may turn a float's last bit, and that a sample at an edge.
TEST(Identity, AMillionUnitsAway) {
    for (const char* name : {"shapes", "everything", "visible lights", "bubbles", "textures on flat shapes"}) {
        const PictureCase picture = find_picture(name, ::testing::TempDir());
        const Film here = film_of(picture.scene, picture.frame);
        const Film there = film_of(translated(picture.scene, {1e6, -1e6, 1e6}), picture.frame);
        RecordProperty(name, std::to_string(share_of_different_pixels(here, there, 1e-5)));
        EXPECT_LE(share_of_different_pixels(here, there, 1e-5), 0.01) << name;
    }
}

// With coordinates that the shift does not round, the very same bits.
TEST(Identity, AMillionBinaryUnitsAway) {
    SceneDesc scene = simple_scene({0.5, 2.5, 7}, {0, 1.25, 0});
    add(scene, "floor", Plane{}, mirror(0.5));
    add(scene, "ball", sphere({-1, 0.75, 0}, 0.75), glass(1.5));
    add(scene, "box", Box{{1, 0.5, 0}, {1, 1, 1}, {}}, shiny({0.9f, 0.3f, 0.2f}));
    add_moving(scene, "mover", sphere({0, 2, 0}, 0.5), shiny({0.3f, 0.3f, 0.9f}),
               {Motion::Interpolation::linear, {key(0, {0, 2, 0}), key(0.5, {0.5, 2, 0})}});
    scene.lights = {light("lamp", lamp({0, 4, 0}, 1), Color(4.0f))};
    scene.cameras[0].shutter.duration = 0.5;
    scene.cameras[0].lens.aperture_radius = 0.125;
    scene.render.max_depth = 4;
    EXPECT_TRUE(same_bits(film_of(scene), film_of(translated(scene, {0x1p20, -0x1p20, 0x1p20}))));
}

// Nothing knows an absolute length. With a power of two no rounding differs either.
TEST(Identity, Scale) {
    for (const char* name : {"shapes", "everything", "visible lights", "bubbles", "textures on round shapes"}) {
        const PictureCase picture = find_picture(name, ::testing::TempDir());
        const Film usual = film_of(picture.scene, picture.frame);
        for (const double by : {0x1p20, 0x1p-20})
            EXPECT_TRUE(same_bits(usual, film_of(scaled(picture.scene, by), picture.frame))) << name << " times " << by;
        for (const double by : {1e6, 1e-6}) {
            const Film other = film_of(scaled(picture.scene, by), picture.frame);
            EXPECT_LE(share_of_different_pixels(usual, other, 1e-4), 0.02) << name << " times " << by;
        }
    }
}

}  // namespace
}  // namespace drt
