// The filter does what a footprint asks for: its width, its direction, no aliasing; against brute-force integrals.
#include <gtest/gtest.h>

#include <vector>

#include "drt/base/constants.h"
#include "drt/texture/lookup.h"
#include "texture/test_textures.h"

namespace drt {
namespace {

using Uv = Vec2<float>;

struct Moments {
    double sum = 0, xx = 0, yy = 0, xy = 0;
};

constexpr int side = 32, per_texel = 2;

/// Pictures with one white texel at every place that a texel can have within a texel of level 3.
const std::vector<TextureMap>& white_texels() {
    static const std::vector<TextureMap> maps = [] {
        std::vector<TextureMap> result;
        for (int i = 0; i < 64; ++i) {
            Image image(side, side, 3);
            image.pixel(side / 2 + i % 8, side / 2 + i / 8)[0] = 1;
            result.push_back(make_texture_map(image));
        }
        return result;
    }();
    return maps;
}

/// Second moments of the filter, in texels: its response to one white texel, the mean over all places of that texel.
Moments filter_moments(Vec2d d1, Vec2d d2) {
    Moments m;
    const auto uv = [&](Vec2d d) { return Uv{float(d.x / side), float(d.y / side)}; };
    const auto around = [](double d) { return d - side * std::floor(d / side + 0.5); };
    for (int place = 0; place < 64; ++place)
        for (int i = 0; i < side * per_texel * side * per_texel; ++i) {
            const double x = (i % (side * per_texel) + 0.5) / per_texel, y = (i / (side * per_texel) + 0.5) / per_texel;
            const Color color = lookup<float>(white_texels()[size_t(place)], uv({x, y}), uv(d1), uv(d2));
            const double value = double(color.r) / (64 * per_texel * per_texel);
            const double dx = around(x - side / 2 - place % 8 - 0.5), dy = around(y - side / 2 - place / 8 - 0.5);
            m.sum += value;
            m.xx += value * dx * dx;
            m.yy += value * dy * dy;
            m.xy += value * dx * dy;
        }
    return m;
}

/// Bilinear interpolation's own variance 1/6, the footprint's w^2 / 12, and what the sum over places of spacing h adds
/// to the second moment of a tent: h^2 / 12.
double expected_moment(double w) { return 1.0 / 6 + w * w / 12 + 1.0 / (12 * per_texel * per_texel); }

TEST(Footprint, FilterIsExactlyAsWideAsTheFootprint) {
    for (const double w : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0}) {
        const Moments m = filter_moments({w, 0}, {0, w});
        const double expected = expected_moment(w);
        EXPECT_NEAR(m.sum, 1, 1e-5) << w;
        EXPECT_NEAR(m.xx, expected, 0.002 * expected) << w;
        EXPECT_NEAR(m.yy, expected, 0.002 * expected) << w;
        EXPECT_NEAR(m.xy, 0, 0.002 * expected) << w;
    }
}

TEST(Footprint, ThinFootprintsBlurAlongTheirAxisOnly) {
    for (const double angle : {0.0, 30.0, 45.0, 90.0, 117.0}) {
        const double c = std::cos(radians(angle)), s = std::sin(radians(angle)), length = 12, width = 2;
        const Moments m = filter_moments({length * c, length * s}, {-width * s, width * c});
        const double along = c * c * m.xx + 2 * c * s * m.xy + s * s * m.yy;
        const double across = s * s * m.xx - 2 * c * s * m.xy + c * c * m.yy;
        EXPECT_NEAR(along, expected_moment(length), 0.005 * along) << angle;
        EXPECT_NEAR(across, expected_moment(width), 0.05 * across) << angle;
    }
}

// Any two sides with the same moments are the same footprint: order, sign and rotation of a square do not matter,
// and two nearly parallel sides are a thin footprint, not a wide one.
TEST(Footprint, DependsOnTheShapeNotOnTheSides) {
    const TextureMap map = make_texture_map(noise_image(64, 64));
    const Uv uv = {0.37f, 0.71f}, a = {0.09f, 0.03f}, b = {-0.01f, 0.04f};
    const Color color = lookup<float>(map, uv, a, b);
    for (const auto& [d1, d2] : {std::pair{b, a}, {Uv{-a.x, -a.y}, b}, {a, Uv{-b.x, -b.y}}}) {
        const Color same = lookup<float>(map, uv, d1, d2);
        EXPECT_NEAR(color.r, same.r, 1e-5);
        EXPECT_NEAR(color.g, same.g, 1e-5);
    }
    const double r = std::sqrt(0.5);
    const Moments parallel = filter_moments({6 * r, 6 * r}, {6.3 * r, 6.3 * r});
    EXPECT_NEAR((parallel.xx + parallel.yy) / 2 - parallel.xy, expected_moment(0), 0.12);  // across: hardly blurred
}

double rms_error(const Image& image, Vec2d d1, Vec2d d2, bool filtered) {
    const TextureMap map = make_texture_map(image);
    std::mt19937 random(9);
    double sum = 0;
    constexpr int count = 100;
    for (int i = 0; i < count; ++i) {
        const double u = double(random()) / 4294967296.0, v = double(random()) / 4294967296.0;
        const Uv uv = {float(u), float(v)};
        const Color color = filtered
                                ? lookup<float>(map, uv, Uv{float(d1.x), float(d1.y)}, Uv{float(d2.x), float(d2.y)})
                                : lookup<float>(map, uv);
        const double error = double(color.r) - slow_footprint(image, u, v, d1, d2, 0, 24);
        sum += error * error;
    }
    return std::sqrt(sum / count);
}

// A picture with detail of 32 texels and more: the second moments say nearly everything about a filter then.
TEST(Footprint, SmoothPicturesMatchTheIntegral) {
    Image image(128, 96, 3);
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 128; ++x)
            for (int c = 0; c < 3; ++c)
                image.pixel(x, y)[c] = float(0.5 + 0.25 * std::sin(2 * pi<double> * (4 * x / 128.0 + 1 * y / 96.0)) +
                                             0.25 * std::cos(2 * pi<double> * (2 * y / 96.0 - 3 * x / 128.0)));
    for (const double w : {0.5, 1.0, 2.0, 4.0, 8.0}) {
        const Vec2d d1 = {w / 128, 0}, d2 = {0, w / 96};
        EXPECT_LT(rms_error(image, d1, d2, true), 0.006) << w;
        const Vec2d long1 = {w / 128, w / 96}, long2 = {-0.2 * w / 128, 0.2 * w / 96};
        EXPECT_LT(rms_error(image, long1, long2, true), 0.012) << w;
    }
}

// White noise is the hardest picture; a filtered lookup must be far nearer to the integral than a plain one.
TEST(Footprint, NoisyPicturesComeNearTheIntegral) {
    const Image image = noise_image(128, 128);
    for (const double w : {3.0, 6.0, 12.0, 24.0}) {
        const Vec2d d1 = {w / 128, 0}, d2 = {0, w / 128};
        EXPECT_LT(rms_error(image, d1, d2, true), 0.4 * rms_error(image, d1, d2, false)) << w;
    }
}

TEST(Footprint, FineCheckerAtADistanceIsGrey) {
    const TextureMap map = make_checker(Color(1.0f), Color(0.0f), 256, 1);
    std::mt19937 random(4);
    for (int i = 0; i < 500; ++i) {
        const Uv uv = {float(random() >> 8) / float(1 << 24), float(random() >> 8) / float(1 << 24)};
        for (const float w : {3.0f, 4.0f, 7.3f, 40.0f}) {
            const float d = w / 256;
            EXPECT_NEAR(lookup<float>(map, uv, Uv{d, 0}, Uv{0, d}).g, 0.5f, 1e-6f) << w;
            // seen at a grazing angle: 8 and 50 times longer than wide
            EXPECT_NEAR(lookup<float>(map, uv, Uv{8 * d, 0}, Uv{0, d}).g, 0.5f, 1e-6f) << w;
            EXPECT_NEAR(lookup<float>(map, uv, Uv{d, d}, Uv{-50 * d, 50 * d}).g, 0.5f, 1e-6f) << w;
        }
        EXPECT_NEAR(lookup<float>(map, uv, Uv{2.0f / 256, 0}, Uv{0, 2.0f / 256}).g, 0.5f, 0.29f);
    }
}

TEST(Footprint, GrowsWithoutAJump) {
    const TextureMap map = make_texture_map(noise_image(64, 64));
    const Uv uv = {0.618f, 0.314f};
    float before = lookup<float>(map, uv).r;
    for (double w = 0; w < 1.5; w = w * 1.001 + 1e-5) {
        const float now = lookup<float>(map, uv, Uv{float(w), 0}, Uv{0, float(w)}).r;
        EXPECT_NEAR(now, before, 0.003) << w;
        before = now;
    }
}

}  // namespace
}  // namespace drt
