// The choice among many lights: stated probabilities are those of the draws, none that can light a point is left out,
// and the mean over draws is the sum over all lights.

#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "drt/light/light_bounds.h"
#include "drt/light/light_sample.h"
#include "light/random_lights.h"
#include "sampling/statistics.h"

namespace drt {
namespace {

using test::LightSet;
using test::RandomLights;

std::vector<LightId> ids_of(const LightTable<double>& t) {
    std::vector<LightId> ids;
    for (size_t i = 0; i < t.points.size(); ++i) ids.push_back(light_id::pack(LightKind::point, i));
    for (size_t i = 0; i < t.rects.size(); ++i) ids.push_back(light_id::pack(LightKind::rect, i));
    for (size_t i = 0; i < t.spheres.size(); ++i) ids.push_back(light_id::pack(LightKind::sphere, i));
    return ids;
}

// A point near the lights: anywhere, or close to one of them, or on it.
Vec3d point_near(const LightSet& set, const std::vector<LightId>& ids, RandomLights& r) {
    const auto light = ids[size_t(r.uniform(0, double(ids.size())))];
    const Vec3d at = visit_light(set.lights, light, [](const auto& l) {
        const LightBounds b = bounds_of(l);
        return (b.lower + b.upper) * 0.5;
    });
    const double where = r.uniform(0, 3);
    return where < 1 ? r.in_box(3 * set.half) : at + r.in_box(1) * r.scale(1e-4, where < 2 ? 0.1 : 3);
}

// The irradiance that one random sample of the light lays on a surface at p, over pi.
double sampled(const LightTable<double>& t, LightId id, const Vec3d& p, const Vec3d& n, RandomLights& r) {
    return visit_light(t, id, [&](const auto& l) {
        const LightSample<double> s = sample_light(l, p, Vec2d{r.uniform(0, 1), r.uniform(0, 1)});
        return s.lit ? double(intensity(s).r) * std::max(0.0, dot(n, s.wi)) : 0.0;
    });
}

TEST(LightTree, NoLightThatLightsAPointHasProbabilityZero) {
    RandomLights r(2);
    for (const LightSet& set : test::light_sets()) {
        const std::vector<LightId> ids = ids_of(set.lights);
        for (int k = 0; k < 3000; ++k) {
            const Vec3d p = point_near(set, ids, r), n = r.direction();
            const LightId id = ids[size_t(r.uniform(0, double(ids.size())))];
            const bool lights = sampled(set.lights, id, p, n, r) > 0 || sampled(set.lights, id, p, n, r) > 0;
            if (!lights) continue;
            ASSERT_GT(choice_probability(set.lights.tree, id, p, Vec3f(n)), 0) << set.name;
            // A world in float, too: lights and point rounded.
            ASSERT_GT(choice_probability(set.lights.tree, id, Vec3f(p), Vec3f(n)), 0) << set.name;
        }
    }
}

// Grazing: the light just reaches above the horizon, or its own plane just passes the point.
TEST(LightTree, GrazingLightsAreNotLeftOut) {
    RandomLights r(3);
    for (int k = 0; k < 2000; ++k) {
        LightTable<double> t;
        const Vec3d p = r.in_box(2), n = r.direction();
        for (int i = 0; i < 20; ++i) {
            const double d = r.scale(1e-3, 1e3);
            const Vec3d side = normalize(cross(n, r.direction()));
            const Vec3d at = p + side * d + n * (d * r.scale(1e-5, 1e-2));
            if (i % 2 == 0) {
                r.add_point(t, at, 1);
            } else {  // stands upright and shines to p; or lies flat, hardly higher than p, and shines down or up
                const Vec3d across = cross(n, side) * (0.1 * d);
                r.add_rect(t, at, across, i % 4 == 1 ? n * (0.1 * d) : side * (0.1 * d), 1);
            }
        }
        plan_light_choice(t);
        for (const LightId id : ids_of(t)) {
            if (sampled(t, id, p, n, r) <= 0) continue;
            ASSERT_GT(choice_probability(t.tree, id, p, Vec3f(n)), 0);
        }
    }
}

TreeDraws drawn_at(const LightTree& tree, const Vec3d& p, const Vec3f& n, std::uint32_t u, std::uint32_t fresh) {
    const std::array<TreePoint<double>, 1> point{{{p, n, u, fresh}}};
    TreeDraws draws;
    choose_lights<double>(tree, point, &draws);
    return draws;
}

/// How often each light is drawn.
std::map<LightId, double> drawn(const LightTree& tree, const Vec3d& p, const Vec3f& n, int points) {
    std::map<LightId, double> counts;
    std::mt19937 bits(7);
    for (int i = 0; i < points; ++i) {
        const auto u = std::uint32_t(bits());
        for (const LightDraw& d : drawn_at(tree, p, n, u, std::uint32_t(bits()))) counts[d.light] += 1;
    }
    return counts;
}

TEST(LightTree, LightsAreDrawnWithTheStatedProbability) {
    RandomLights r(4);
    const auto sets = test::light_sets();
    const double level = test::sidak(0.01, 3 * int(sets.size()));
    for (const LightSet& set : sets) {
        const std::vector<LightId> ids = ids_of(set.lights);
        for (int k = 0; k < 3; ++k) {
            const Vec3d p = point_near(set, ids, r);
            const Vec3f n(r.direction());
            constexpr int points = 50000;
            auto counts = drawn(set.lights.tree, p, n, points);
            std::vector<double> observed, expected;
            double sum = 0;
            for (const LightId id : ids) {
                const double probability = choice_probability(set.lights.tree, id, p, n);
                sum += probability;
                observed.push_back(counts[id]);
                expected.push_back(points * tree_draws * probability);
            }
            // A node's bound may promise what none of its children can send: then nothing is drawn.
            EXPECT_LT(sum, 1 + 1e-5) << set.name;
            observed.push_back(counts[no_light]);
            expected.push_back(points * tree_draws * (sum < 1 - 1e-5 ? 1 - sum : 0));
            // One draw from each quarter: less spread than chi^2 expects, never more.
            const double all_in_one = *std::max_element(expected.begin(), expected.end());
            if (all_in_one > 0.999 * points * tree_draws) continue;
            EXPECT_GT(test::chi2_p_value(observed, expected), level) << set.name;
        }
    }
}

TEST(LightTree, PointsTogetherDrawWhatTheyDrawAlone) {
    RandomLights r(6);
    for (const LightSet& set : test::light_sets()) {
        std::vector<TreePoint<double>> points;
        for (std::uint32_t k = 0; k < points_at_once; ++k)
            points.push_back({r.in_box(2 * set.half), Vec3f(r.direction()), k * 0x9e3779b9u, 77u * k});
        std::array<TreeDraws, points_at_once> together;
        choose_lights<double>(set.lights.tree, points, together.data());
        for (size_t i = 0; i < points.size(); ++i) {
            const TreeDraws alone = drawn_at(set.lights.tree, points[i].p, points[i].n, points[i].u, points[i].fresh);
            for (size_t k = 0; k < alone.size(); ++k) {
                EXPECT_EQ(together[i][k].light, alone[k].light);
                EXPECT_EQ(together[i][k].probability, alone[k].probability);
            }
        }
    }
}

// A draw says the probability that choice_probability says.
TEST(LightTree, DrawsAndProbabilitiesAgreeToTheLastDigits) {
    RandomLights r(5);
    for (const LightSet& set : test::light_sets()) {
        for (int k = 0; k < 200; ++k) {
            const Vec3d p = r.in_box(2 * set.half);
            const Vec3f n(r.direction());
            const auto u = std::uint32_t(k) * 0x9e3779b9u, fresh = 77u * std::uint32_t(k);
            for (const LightDraw& d : drawn_at(set.lights.tree, p, n, u, fresh)) {
                if (d.light == no_light) continue;
                EXPECT_NEAR(d.probability / choice_probability(set.lights.tree, d.light, p, n), 1, 1e-5f);
            }
        }
    }
}

// Means over draws, and over the points of the lights, against the sum over all lights, to 99 % for all together.
TEST(LightTree, TheMeanOverDrawsIsTheSumOverAllLights) {
    RandomLights r(6);
    std::mt19937 bits(8);
    const auto sets = test::light_sets();
    const double level = test::sidak(0.01, 4 * int(sets.size()));
    for (const LightSet& set : sets) {
        const std::vector<LightId> ids = ids_of(set.lights);
        for (int k = 0; k < 4; ++k) {
            const Vec3d p = r.in_box(set.half), n = r.direction();
            test::Mean chosen, all;
            // A light that is hardly ever drawn would be worth 1000 draws once in a while: no mean shows it.
            std::map<LightId, bool> rare;
            for (const LightId id : ids) rare[id] = choice_probability(set.lights.tree, id, p, Vec3f(n)) < 1e-3;
            for (int i = 0; i < 20000; ++i) {
                const auto u = std::uint32_t(bits());
                double sum = 0;
                for (const LightDraw& d : drawn_at(set.lights.tree, p, Vec3f(n), u, std::uint32_t(bits())))
                    if (d.light != no_light && !rare[d.light])
                        sum += sampled(set.lights, d.light, p, n, r) / (tree_draws * double(d.probability));
                chosen.add(sum);
            }
            for (int i = 0; i < 400; ++i) {
                double sum = 0;
                for (const LightId id : ids)
                    if (!rare[id]) sum += sampled(set.lights, id, p, n, r);
                all.add(sum);
            }
            const double error =
                std::sqrt(std::max(chosen.variance() / chosen.n + all.variance() / all.n, 0.0)) + 1e-6 * all.mean();
            const double z = std::abs(chosen.mean() - all.mean()) / std::max(error, 1e-30);
            EXPECT_GT(2 * test::normal_tail(z), level) << set.name << ": " << chosen.mean() << " and " << all.mean();
        }
    }
}

// Deep in a large tree: all lights of a cluster are reached although its probability uses up 24 binary digits.
TEST(LightTree, FreshDigitsReachEveryLightOfADeepTree) {
    RandomLights r(9);
    LightTable<double> t;
    for (int i = 0; i < 3000; ++i) r.add_point(t, Vec3d{1000, 0, 0} + r.in_box(1), 1);
    for (int i = 0; i < 3000; ++i) r.add_point(t, r.in_box(1), 1);
    plan_light_choice(t);
    const Vec3d p{0, 0, 5};
    const Vec3f n{0, 0, -1};
    // The far cluster gets a millionth; look at draws that begin in it.
    double far = 0;
    for (int i = 0; i < 3000; ++i) far += choice_probability(t.tree, light_id::pack(LightKind::point, size_t(i)), p, n);
    EXPECT_GT(far, 1e-8);
    EXPECT_LT(far, 1e-3);
    auto counts = drawn(t.tree, p, n, 500000);
    std::vector<double> observed, expected;
    for (const LightId id : ids_of(t)) {
        observed.push_back(counts[id]);
        expected.push_back(500000.0 * tree_draws * choice_probability(t.tree, id, p, n));
    }
    EXPECT_GT(test::chi2_p_value(observed, expected), 0.001);
}

TEST(LightTree, IsTheSameForTheSameLights) {
    const auto a = test::light_sets(), b = test::light_sets();
    for (size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].lights.tree.nodes.size(), b[i].lights.tree.nodes.size());
        EXPECT_EQ(0, std::memcmp(a[i].lights.tree.nodes.data(), b[i].lights.tree.nodes.data(),
                                 a[i].lights.tree.nodes.size() * sizeof(LightNode)));
    }
}

}  // namespace
}  // namespace drt
