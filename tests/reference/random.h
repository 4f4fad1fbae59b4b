#pragma once
// Plain pseudo-random numbers.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "drt/base/vec.h"

namespace drt::reference {

class Random {
public:
    Random(std::uint64_t seed, int frame, int x, int y) {
        std::seed_seq words{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(frame), std::uint32_t(x),
                            std::uint32_t(y)};
        engine_.seed(words);
    }
    /// Uniform in [0, 1).
    double uniform() { return double(engine_() >> 11) * 0x1p-53; }
    /// Uniform in [low, high).
    double between(double low, double high) { return low + (high - low) * uniform(); }

    /// A point of the unit disc: uniform over its area, or (radial) with its radius uniform in [0, 1).
    Vec2d disc(bool radial) {
        const double radius = radial ? uniform() : std::sqrt(uniform());
        const double azimuth = between(0, 2 * std::numbers::pi);
        return {radius * std::cos(azimuth), radius * std::sin(azimuth)};
    }

private:
    std::mt19937_64 engine_;
};

/// Two unit vectors perpendicular to each other and to `axis`.
inline void perpendiculars(const Vec3d& axis, Vec3d& x, Vec3d& y) {
    x = normalize(cross(axis, std::abs(axis.x) < 0.7 * length(axis) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    y = normalize(cross(axis, x));
}

}  // namespace drt::reference
