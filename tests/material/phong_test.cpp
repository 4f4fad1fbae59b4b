#include "drt/material/phong.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "drt/material/material_table.h"

namespace drt {
namespace {

using L = long double;

Vec3d random_direction(std::mt19937& engine) {
    const auto u = [&] { return double(engine()) * 0x1p-31 - 1; };
    for (;;) {
        const Vec3d v{u(), u(), u()};
        if (const double r2 = dot(v, v); r2 < 1 && r2 > 1e-3) return normalize(v);
    }
}

// The definition: R = 2 (N.L) N - L, (R.V)^alpha, nothing from below.
L slow_specular(const Vec3f& n, const Vec3f& wi, const Vec3f& wo, L shininess) {
    const Vec3<L> nn(n), l(wi), v(wo);
    const L cos_i = dot(nn, l);
    if (cos_i <= 0) return 0;
    const Vec3<L> r = normalize(nn * (2 * cos_i) - l);
    const L c = dot(r, normalize(v));
    return c <= 0 ? 0 : std::pow(c, shininess);
}

TEST(Phong, HighlightsAreThoseOfTheFormula) {
    std::mt19937 engine(1);
    for (const double shininess : {0.0, 1.0, 20.0, 1e3, 1e5}) {
        const PhongParameters<float> p{Color(0.0f), Color{1.0f, 0.5f, 0.25f}, float(shininess)};
        int bright = 0;
        for (int i = 0; i < 5000; ++i) {
            const Vec3f n(random_direction(engine)), wi(random_direction(engine));
            const float cos_i = dot(n, wi);
            // near the mirror direction, where there is something to see
            const Vec3d mirror = Vec3d(n) * (2.0 * double(cos_i)) - Vec3d(wi);
            const Vec3f wo(normalize(mirror + random_direction(engine) / std::sqrt(shininess + 1)));
            const Color found = phong_specular(p, n, wi, wo, cos_i);
            const double truth = double(slow_specular(n, wi, wo, L(shininess)));
            // unit vectors in float leave R.V uncertain by some 1e-7 of the lobe's own width
            const double lobe = std::sqrt(shininess + 1);
            EXPECT_NEAR(double(found.r), truth, 3e-6 * lobe) << shininess;
            EXPECT_EQ(found.g, found.r * 0.5f);
            bright += truth > 0.1;
        }
        EXPECT_GT(bright, 1000);
    }
}

TEST(Phong, NothingComesFromBelow) {
    const PhongParameters<float> p{Color(1.0f), Color(1.0f), 0.0f};
    EXPECT_EQ(phong_diffuse(p, -0.3f), Color(0.0f));
    EXPECT_EQ(phong_diffuse(p, 0.25f), Color(0.25f));
    const Vec3f n{0, 0, 1}, below = normalize(Vec3f{1, 0, -1}), wo{0, 0, 1};
    EXPECT_EQ(phong_specular(p, n, below, wo, dot(n, below)), Color(0.0f));
}

TEST(Phong, LanesSeeWhatScalarsSee) {
    using F = Pack<float>::F;
    std::mt19937 engine(2);
    for (int k = 0; k < 200; ++k) {
        const Vec3f n(random_direction(engine)), wo(random_direction(engine));
        Vec3<F> wi;
        for (int i = 0; i < Pack<float>::width; ++i) {
            const Vec3f v(random_direction(engine));
            wi.x[i] = v.x, wi.y[i] = v.y, wi.z[i] = v.z;
        }
        const PhongParameters<F> lanes{Color3<F>(F(0.5f)), Color3<F>(F(0.7f)), F(30.0f)};
        const PhongParameters<float> one{Color(0.5f), Color(0.7f), 30.0f};
        const Color3<F> found = phong_specular(lanes, Vec3<F>(n), wi, Vec3<F>(wo), dot(Vec3<F>(n), wi));
        for (int i = 0; i < Pack<float>::width; ++i) {
            const Vec3f v{lane(wi.x, i), lane(wi.y, i), lane(wi.z, i)};
            EXPECT_NEAR(lane(found.r, i), phong_specular(one, n, v, wo, dot(n, v)).r, 1e-5f);
        }
    }
}

TEST(MaterialTable, ColoursAreGatheredByMaterial) {
    using F = Pack<float>::F;
    using I = Pack<float>::I;
    ColorColumn column;
    for (int i = 0; i < 20; ++i) column.push_back({float(i), float(2 * i), float(3 * i)});
    const I id([](auto i) { return (int(i) * 7) % 20; });
    const Color3<F> found = gather_color<F>(column, id);
    for (int i = 0; i < Pack<float>::width; ++i) {
        EXPECT_EQ(lane(found.r, i), float(id[i]));
        EXPECT_EQ(lane(found.b, i), float(3 * id[i]));
    }
}

}  // namespace
}  // namespace drt
