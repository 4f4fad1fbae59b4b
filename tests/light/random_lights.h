#pragma once
// Tables of random lights of every kind, and awkward ones.

#include <random>
#include <string>
#include <vector>

#include "drt/light/light_choice.h"

namespace drt::test {

class RandomLights {
public:
    explicit RandomLights(unsigned seed) : engine_(seed) {}

    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(engine_); }
    /// Log-uniform.
    double scale(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
    Vec3d in_box(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec3d direction() {
        for (;;) {
            const Vec3d v = in_box(1);
            if (dot(v, v) > 0.01 && dot(v, v) < 1) return normalize(v);
        }
    }

    LightCommon<float> common(double strength) { return {Color(float(strength)), true, -1}; }
    void add_point(LightTable<double>& t, const Vec3d& at, double strength) {
        t.points.push_back({common(strength), at});
    }
    void add_sphere(LightTable<double>& t, const Vec3d& at, double radius, double radiance) {
        t.spheres.push_back({common(radiance), at, radius, uniform(0, 1) < 0.5});
    }
    void add_rect(LightTable<double>& t, const Vec3d& corner, const Vec3d& x, const Vec3d& y, double radiance,
                  bool two_sided = false) {
        t.rects.push_back(make_rect_light(common(radiance), corner, x, y, two_sided));
    }
    /// Of any kind, within a cube.
    void add_any(LightTable<double>& t, double half, double size, double strength) {
        const double kind = uniform(0, 4);
        const Vec3d at = in_box(half);
        if (kind < 1)
            add_point(t, at, strength);
        else if (kind < 2)
            add_sphere(t, at, size * uniform(0.01, 1), strength);
        else
            add_rect(t, at, direction() * (size * uniform(0.01, 1)), direction() * (size * uniform(0.01, 1)), strength,
                     kind < 3);
    }

private:
    std::mt19937 engine_;
};

struct LightSet {
    std::string name;
    LightTable<double> lights;
    double half;  ///< of the cube that they are in
};

/// Each has more lights than every hit asks.
inline std::vector<LightSet> light_sets() {
    RandomLights r(1);
    std::vector<LightSet> sets;
    const auto add = [&](const std::string& name, int count, double half, auto&& one) {
        LightSet s{name, {}, half};
        for (int i = 0; i < count; ++i) one(s.lights, i);
        plan_light_choice(s.lights);
        sets.push_back(std::move(s));
    };
    const auto mixed = [&](LightTable<double>& t, int) { r.add_any(t, 5, 2, r.scale(0.1, 10)); };
    for (const int n : {17, 18, 64, 65, 300}) add("mixed " + std::to_string(n), n, 5, mixed);
    add("powers from 1e-9 to 1e9", 40, 5, [&](auto& t, int) { r.add_any(t, 5, 1, r.scale(1e-9, 1e9)); });
    add("a sun and lamps", 20, 5, [&](auto& t, int i) {
        if (i == 0)
            r.add_point(t, {6e4, 8e4, 0}, 1e9);
        else
            r.add_any(t, 5, 0.5, 1);
    });
    add("all at one point", 30, 5, [&](auto& t, int i) { r.add_point(t, {1, 2, 3}, 1 + i); });
    add("in a row", 100, 5, [&](auto& t, int i) { r.add_point(t, {0.1 * i - 5, 1, 0}, 1); });
    add("a flat ceiling", 144, 6, [&](auto& t, int i) {
        r.add_rect(t, {double(i % 12) - 6, 2, double(i / 12) - 6}, {0.5, 0, 0}, {0, 0, 0.5}, 1);
    });
    add("coincident rectangles", 20, 2, [&](auto& t, int i) {
        r.add_rect(t, {0, 1, 0}, {1, 0, 0}, {0, 0, i % 2 ? 1.0 : -1.0}, 1);
    });
    add("one inside another", 18, 5, [&](auto& t, int i) { r.add_sphere(t, {0, 0, 0}, 0.25 * (i + 1), 1); });
    add("far from the origin", 50, 5, [&](auto& t, int) {
        LightTable<double> one;
        r.add_any(one, 5, 1, 1);
        for (auto l : one.points) l.position += Vec3d{1e4, 0, 0}, t.points.push_back(l);
        for (auto l : one.spheres) l.center += Vec3d{1e4, 0, 0}, t.spheres.push_back(l);
        for (auto l : one.rects)
            t.rects.push_back(make_rect_light(l, l.corner + Vec3d{1e4, 0, 0}, l.edge_x, l.edge_y, l.two_sided));
    });
    return sets;
}

}  // namespace drt::test
