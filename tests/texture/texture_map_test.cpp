// Every level of the pyramid holds the picture: same mean, right sizes, nothing shifted.
#include "drt/texture/texture_map.h"

#include <gtest/gtest.h>

#include "drt/base/diagnostic.h"
#include "texture/test_textures.h"

namespace drt {
namespace {

const float* texel(const TextureMap& map, size_t level, int x, int y) {
    const TextureMap::Level& l = map.levels[level];
    return &map.texels[size_t(l.offset + (y * l.width + x) * floats_per_texel)];
}

TEST(TextureMap, EveryLevelKeepsTheMean) {
    for (const auto& [w, h] : {std::pair{1, 1}, {1, 37}, {37, 1}, {3, 5}, {7, 7}, {64, 64}, {101, 66}, {256, 3}}) {
        const Image image = noise_image(w, h);
        const TextureMap map = make_texture_map(image);
        for (size_t level = 0; level < map.levels.size(); ++level)
            for (int c = 0; c < 3; ++c) {
                const TextureMap::Level& l = map.levels[level];
                double sum = 0;
                for (int y = 0; y < l.height; ++y)
                    for (int x = 0; x < l.width; ++x) sum += double(texel(map, level, x, y)[c]);
                EXPECT_NEAR(sum / (l.width * double(l.height)), slow_mean(image, c), 2e-7)
                    << w << "x" << h << " " << level;
            }
    }
}

TEST(TextureMap, SidesHalveDownToOneTexel) {
    const TextureMap map = make_texture_map(noise_image(13, 3));
    ASSERT_EQ(map.levels.size(), 4u);
    const int widths[] = {13, 6, 3, 1}, heights[] = {3, 1, 1, 1};
    int offset = 0;
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(map.levels[i].width, widths[i]);
        EXPECT_EQ(map.levels[i].height, heights[i]);
        EXPECT_EQ(map.levels[i].offset, offset);
        offset += widths[i] * heights[i] * floats_per_texel;
    }
    EXPECT_EQ(map.texels.size(), size_t(offset));
}

// A ramp stays where it was, to a twentieth of the level's texel (exactly, where all sides are even).
TEST(TextureMap, LevelsAreNotShifted) {
    for (const int width : {64, 63, 37, 5}) {
        Image image(width, 1, 3);
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, 0)[c] = float((x + 0.5) / width);
        const TextureMap map = make_texture_map(image);
        for (size_t level = 0; level < map.levels.size(); ++level)
            for (int x = 0; x < map.levels[level].width; ++x)
                EXPECT_NEAR(texel(map, level, x, 0)[0], (x + 0.5) / map.levels[level].width,
                            (width == 64 ? 1e-7 : 0.05) / map.levels[level].width)
                    << width << " " << level;
    }
}

TEST(TextureMap, RefusesEmptyPictures) {
    EXPECT_THROW(make_texture_map(Image()), Error);
    EXPECT_THROW(make_texture_map(Image(2, 2, 1)), Error);
}

TEST(TextureMap, TakesTheFirstThreeChannels) {
    Image image(1, 2, 4);
    for (size_t i = 0; i < 8; ++i) image.data[i] = float(i);
    const TextureMap map = make_texture_map(image);
    EXPECT_EQ(texel(map, 0, 0, 1)[0], 4.0f);
    EXPECT_EQ(texel(map, 0, 0, 1)[2], 6.0f);
    EXPECT_EQ(texel(map, 1, 0, 0)[1], 3.0f);
}

TEST(TextureMap, CheckerAlternates) {
    const TextureMap map = make_checker(Color(1, 0, 1), Color(0.5f), 4, 2);
    EXPECT_EQ(map.levels[0].width, 8);
    EXPECT_EQ(texel(map, 0, 0, 0)[1], 0.0f);
    EXPECT_EQ(texel(map, 0, 2, 1)[1], 0.5f);
    EXPECT_EQ(texel(map, 0, 2, 2)[1], 0.0f);
    const TextureMap missing = make_missing_texture();
    EXPECT_GT(texel(missing, 0, 0, 0)[0], 2 * texel(missing, 0, 0, 0)[1]);
}

}  // namespace
}  // namespace drt
