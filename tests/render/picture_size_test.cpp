// Pictures and sample counts that fill no tile, no packet and no power of two.

#include <gtest/gtest.h>

#include "pictures/scene_kit.h"
#include "support/render_picture.h"

namespace drt {
namespace {

/// A glowing wall that covers the whole picture: every sample is the same colour.
SceneDesc wall(int width, int height) {
    SceneDesc scene = simple_scene({0, 0, 1}, {0, 0, 0});
    scene.render.width = width;
    scene.render.height = height;
    scene.render.filter = Filter{};
    scene.ambient_light = Color(1.0f);
    scene.cameras[0].lens.aperture_radius = 0.1;
    add(scene, "wall", Plane{{0, 0, 0}, {0, 0, 1}}, glow("", {0.25f, 0.5f, 1}));
    return scene;
}

void expect_wall(int width, int height, int spp, int tile_size) {
    RenderOptions options;
    options.spp = spp;
    options.tile_size = tile_size;
    const RenderResult result = render_scene(wall(width, height), {}, options);
    const Image picture = resolve(result.film);
    ASSERT_EQ(picture.width, width);
    ASSERT_EQ(picture.height, height);
    EXPECT_EQ(result.counters.camera_rays, std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(spp));
    for (size_t i = 0; i < picture.data.size(); i += 4) {
        const std::vector<float> pixel(picture.data.begin() + long(i), picture.data.begin() + long(i) + 4);
        ASSERT_EQ(pixel, (std::vector<float>{0.25f, 0.5f, 1, 1}))
            << "pixel " << i / 4 << " of " << width << " x " << height << ", " << spp << " samples";
    }
}

TEST(PictureSize, AnySizeAndCountFillsEveryPixel) {
    for (const int spp : {1, 2, 7, 13}) {
        expect_wall(1, 1, spp, 32);
        expect_wall(1, 37, spp, 32);
        expect_wall(37, 1, spp, 32);
        expect_wall(41, 23, spp, 16);
        expect_wall(17, 33, spp, 8);
        expect_wall(5, 3, spp, 4);
    }
    expect_wall(2049, 1, 3, 32);
    expect_wall(16384, 3, 2, 32);
}

// The picture's left half is on the left, its top on the top, in the whole picture and in any corner of a tile.
TEST(PictureSize, PixelsAreInTheirPlaces) {
    SceneDesc scene = wall(37, 19);
    scene.render.filter.kind = Filter::Kind::point;
    scene.cameras[0].lens.aperture_radius = 0;
    scene.cameras[0].fov_degrees_start = 90;  // the wall's x goes from -1 to 1
    // One small square before the centre of pixel (5, 16).
    const double x = 2 * 5.5 / 37 - 1, y = (19 - 2 * 16.5) / 37;
    add(scene, "mark", Disc{{x, y, 0.001}, {0, 0, 1}, 0.01}, glow("", {1, 0, 0}));
    RenderOptions options;
    options.spp = 1;
    const Image picture = resolve(render_scene(scene, {}, options).film);
    for (int row = 0; row < 19; ++row)
        for (int column = 0; column < 37; ++column)
            EXPECT_EQ(picture.pixel(column, row)[0], column == 5 && row == 16 ? 1.0f : 0.25f) << column << ", " << row;
}

}  // namespace
}  // namespace drt
