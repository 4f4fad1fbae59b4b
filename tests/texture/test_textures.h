#pragma once
// Pictures for texture tests, and slow lookups in double precision to compare with.

#include <array>
#include <cmath>
#include <random>

#include "drt/base/vec.h"
#include "drt/texture/texture_map.h"

namespace drt {

inline Image noise_image(int width, int height, unsigned seed = 1) {
    Image image(width, height, 3);
    std::mt19937 random(seed);
    for (float& v : image.data) v = float(random() >> 8) / float(1 << 24);
    return image;
}

/// Bilinear interpolation of the repeated picture.
inline double slow_bilinear(const Image& image, double u, double v, int channel) {
    const double x = (u - std::floor(u)) * image.width - 0.5, y = (v - std::floor(v)) * image.height - 0.5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    const auto texel = [&](int a, int b) {
        return double(image.pixel((a + image.width) % image.width, (b + image.height) % image.height)[channel]);
    };
    const double fx = x - i, fy = y - j;
    return (1 - fy) * ((1 - fx) * texel(i, j) + fx * texel(i + 1, j)) +
           fy * ((1 - fx) * texel(i, j + 1) + fx * texel(i + 1, j + 1));
}

inline double slow_mean(const Image& image, int channel) {
    double sum = 0;
    for (size_t i = size_t(channel); i < image.data.size(); i += 3) sum += double(image.data[i]);
    return sum / (image.width * double(image.height));
}

/// The mean over the parallelogram around (u, v) with sides d1, d2, by n x n midpoints.
inline double slow_footprint(const Image& image, double u, double v, Vec2d d1, Vec2d d2, int channel, int n) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double a = (i + 0.5) / n - 0.5, b = (j + 0.5) / n - 0.5;
            sum += slow_bilinear(image, u + a * d1.x + b * d2.x, v + a * d1.y + b * d2.y, channel);
        }
    return sum / (n * double(n));
}

}  // namespace drt
