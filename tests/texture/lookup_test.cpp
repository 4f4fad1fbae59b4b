// Lookups against double precision; lanes against one ray; odd sizes, odd coordinates.
#include "drt/texture/lookup.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>

#include "texture/test_textures.h"

namespace drt {
namespace {

using Uv = Vec2<float>;
constexpr float infinity = std::numeric_limits<float>::infinity();
const Uv no_side = {0.0f, 0.0f};

void expect_same_bits(const Color& a, const Color& b, const char* what) {
    EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0) << what << ": " << a.r << " " << b.r;
}

TEST(Lookup, ZeroFootprintIsBilinear) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-3.0f, 3.0f);
    for (const auto& [w, h] : {std::pair{1, 1}, {1, 7}, {7, 1}, {5, 3}, {16, 16}, {33, 17}, {640, 2}}) {
        const Image image = noise_image(w, h);
        const TextureMap map = make_texture_map(image);
        for (int i = 0; i < 2000; ++i) {
            const Uv uv = {place(random), place(random)};
            const Color color = lookup<float>(map, uv);
            // a float coordinate near 3 is good to 2.4e-7 of the picture's side
            const double tolerance = 1e-6 + 5e-7 * std::max(w, h);
            EXPECT_NEAR(color.r, slow_bilinear(image, double(uv.x), double(uv.y), 0), tolerance);
            EXPECT_NEAR(color.b, slow_bilinear(image, double(uv.x), double(uv.y), 2), tolerance);
            expect_same_bits(color, lookup<float>(map, uv, no_side, no_side), "zero footprint");
        }
    }
}

TEST(Lookup, TexelCentresGiveTexels) {
    const Image image = noise_image(8, 4);
    const TextureMap map = make_texture_map(image);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const Color color = lookup<float>(map, Uv{(float(x) + 0.5f) / 8, (float(y) + 0.5f) / 4});
            EXPECT_EQ(color, Color(image.pixel(x, y)[0], image.pixel(x, y)[1], image.pixel(x, y)[2])) << x << ' ' << y;
        }
}

TEST(Lookup, RepeatsWithoutASeam) {
    const TextureMap map = make_texture_map(noise_image(13, 7));
    const Uv side = {0.05f, 0.0f}, other = {0.0f, 0.1f};
    for (int i = 0; i < 64; ++i) {
        const float t = float(i) / 64;
        for (const float whole : {-2.0f, -1.0f, 1.0f, 5.0f}) {
            expect_same_bits(lookup<float>(map, Uv{t, t}), lookup<float>(map, Uv{t + whole, t - whole}), "whole shift");
            expect_same_bits(lookup<float>(map, Uv{t, t}, side, other),
                             lookup<float>(map, Uv{t + whole, t - whole}, side, other), "whole shift, footprint");
        }
        for (const Uv& d : {no_side, side}) {
            const auto near = [&](const Color& a, const Color& b) {
                EXPECT_NEAR(a.r, b.r, 2e-4);
                EXPECT_NEAR(a.g, b.g, 2e-4);
            };
            near(lookup<float>(map, Uv{-1e-5f, t}, d, other), lookup<float>(map, Uv{1e-5f, t}, d, other));
            near(lookup<float>(map, Uv{1 - 1e-5f, t}, d, other), lookup<float>(map, Uv{1 + 1e-5f, t}, d, other));
            near(lookup<float>(map, Uv{t, -1e-5f}, d, other), lookup<float>(map, Uv{t, 1e-5f}, d, other));
        }
    }
}

TEST(Lookup, HugeFootprintsSeeTheMean) {
    for (const auto& [w, h] : {std::pair{1, 1}, {16, 16}, {33, 17}, {1, 64}, {100, 3}}) {
        const Image image = noise_image(w, h);
        const TextureMap map = make_texture_map(image);
        for (const float side : {100.0f, 1e6f, 1e30f, infinity, std::nanf("")})
            for (const auto& [d1, d2] :
                 {std::pair{Uv{side, 0}, Uv{0, side}}, {Uv{side, side}, Uv{0, 0}}, {Uv{0, 0}, Uv{0, side}}}) {
                if (h == 1 && d1.x == 0) continue;
                if (d1.x == 0 && side == 100.0f) continue;
                const Color color = lookup<float>(map, Uv{0.3f, 0.7f}, d1, d2);
                EXPECT_NEAR(color.r, slow_mean(image, 0), 1e-6) << w << "x" << h << " " << side;
                EXPECT_NEAR(color.g, slow_mean(image, 1), 1e-6) << w << "x" << h << " " << side;
            }
    }
}

TEST(Lookup, AnyCoordinateIsSafe) {
    const Image image = noise_image(19, 31);
    const TextureMap map = make_texture_map(image);
    const float big = std::numeric_limits<float>::max();
    const Uv small = {0.01f, 0.02f}, wide = {0.4f, -0.1f};
    for (const float u : {1e30f, -1e30f, big, -big, infinity, -infinity, std::nanf(""), -1e-30f, -1e-10f, 0.99999994f,
                          16777217.0f, std::numeric_limits<float>::denorm_min(), -0.0f})
        for (const Uv& uv : {Uv{u, 0.3f}, Uv{0.3f, u}, Uv{u, u}})
            for (const Color& color : {lookup<float>(map, uv), lookup<float>(map, uv, small, wide)}) {
                EXPECT_GE(color.r, 0.0f);
                EXPECT_LE(color.r, 1.0f);
            }
    expect_same_bits(lookup<float>(map, Uv{infinity, std::nanf("")}), lookup<float>(map, Uv{0, 0}), "non-finite");
}

struct Query {
    Uv uv, d1, d2;
};

Query random_query(std::mt19937& random) {
    std::uniform_real_distribution<float> place(-2.0f, 2.0f), exponent(-9.0f, 3.0f);
    float v[6] = {place(random), place(random)};
    if (random() % 4 != 0)
        for (int k = 2; k < 6; ++k) v[k] = place(random) * std::pow(10.0f, exponent(random));
    if (random() % 64 == 0) v[random() % 6] = std::nanf("");
    if (random() % 64 == 0) v[random() % 6] = infinity;
    return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
}

template <int W>
Color3<Lane<float, W>> lookup_lanes(const TextureMap& map, const std::array<Query, W>& q, bool filtered) {
    using T = Lane<float, W>;
    const auto lanes = [&](auto get) { return T([&](auto i) { return get(q[i]); }); };
    const Vec2<T> uv = {lanes([](const Query& a) { return a.uv.x; }), lanes([](const Query& a) { return a.uv.y; })};
    const Vec2<T> d1 = {lanes([](const Query& a) { return a.d1.x; }), lanes([](const Query& a) { return a.d1.y; })};
    const Vec2<T> d2 = {lanes([](const Query& a) { return a.d2.x; }), lanes([](const Query& a) { return a.d2.y; })};
    return filtered ? lookup<T>(map, uv, d1, d2) : lookup<T>(map, uv);
}

// A ray's colour is the same bits whatever rays share its batch: the picture cannot depend on tiles or threads. One
// ray alone gives the same number too, up to the multiply-adds that the compiler fuses differently for scalars.
template <int W>
void compare_lanes(const TextureMap& map) {
    std::mt19937 random(5);
    for (int round = 0; round < 4000 / W; ++round)
        for (const bool filtered : {false, true}) {
            std::array<Query, W> queries;
            for (Query& q : queries) q = random_query(random);
            const auto mixed = lookup_lanes<W>(map, queries, filtered);
            for (int i = 0; i < W; ++i) {
                const Query& q = queries[size_t(i)];
                std::array<Query, W> same;
                same.fill(q);
                const auto alone = lookup_lanes<W>(map, same, filtered);
                expect_same_bits({lane(mixed.r, i), lane(mixed.g, i), lane(mixed.b, i)},
                                 {lane(alone.r, 0), lane(alone.g, 0), lane(alone.b, 0)}, "other rays in the batch");
                const Color one = filtered ? lookup<float>(map, q.uv, q.d1, q.d2) : lookup<float>(map, q.uv);
                EXPECT_NEAR(lane(mixed.r, i), one.r, 1e-5f);
                EXPECT_NEAR(lane(mixed.b, i), one.b, 1e-5f);
#if !defined(__FMA__)
                expect_same_bits({lane(mixed.r, i), lane(mixed.g, i), lane(mixed.b, i)}, one, "one ray");
#endif
            }
        }
}

TEST(Lookup, LanesDoNotAffectEachOther) {
    for (const auto& [w, h] : {std::pair{64, 64}, {37, 101}, {1, 1}, {1, 50}}) {
        const TextureMap map = make_texture_map(noise_image(w, h));
        compare_lanes<4>(map);
        compare_lanes<8>(map);
        compare_lanes<16>(map);
    }
}

}  // namespace
}  // namespace drt
