// Texture lookups per second of one thread.
//
//   texture_bench [SIDE]      a SIDE x SIDE texture, 1024 by default
//
// Two orders of access: neighbouring rays (a slowly moving uv, as camera rays see) and scattered ones (a random uv, the
// worst case for the caches).

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <random>
#include <vector>

#include "drt/texture/lookup.h"

namespace {

using namespace drt;

Image noise(int side) {
    Image image(side, side, 3);
    std::mt19937 random(1);
    for (float& v : image.data) v = float(random() >> 8) / float(1 << 24);
    return image;
}

std::vector<float> coordinates(bool scattered, int side) {
    std::vector<float> uv(1 << 16);
    std::mt19937 random(2);
    for (size_t i = 0; i < uv.size(); ++i)
        uv[i] = scattered ? float(random() >> 8) / float(1 << 24) : 0.7f * float(i / 2) / float(side);
    return uv;
}

/// The best of several short runs, so that other programs disturb little.
template <class T>
double lookups_per_second(const TextureMap& map, const std::vector<float>& uv, float d1, float d2, bool filtered) {
    constexpr size_t width = size_t(width_of<T>);
    const Vec2<T> side1 = {T(d1), T(0.3f * d2)}, side2 = {T(-0.3f * d1), T(d2)};
    Color3<T> sum(T(0.0f));
    double best = 0;
    for (int run = 0; run < 25; ++run) {
        const auto start = std::chrono::steady_clock::now();
        for (size_t i = 0; i + 2 * width <= uv.size(); i += 2 * width) {
            const Vec2<T> at = {load<T>(&uv[i]), load<T>(&uv[i + width])};
            sum += filtered ? lookup<T>(map, at, side1, side2) : lookup<T>(map, at);
        }
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        best = std::max(best, double(uv.size() / 2) / seconds.count());
    }
    if (!(lane(sum.r, 0) >= 0)) std::abort();  // also keeps the work from being optimised away
    return best;
}

template <class T>
void report(const TextureMap& map, int side) {
    const float texel = 1.0f / float(side);
    for (const bool scattered : {false, true}) {
        const std::vector<float> uv = coordinates(scattered, side);
        const auto rate = [&](float d1, float d2, bool filtered) {
            return lookups_per_second<T>(map, uv, d1 * texel, d2 * texel, filtered) / 1e6;
        };
        fmt::print("{:2} lanes, {:9} | bilinear {:6.1f} | trilinear 1 tap {:6.1f} | 4 taps {:6.1f} | 8 taps {:6.1f}\n",
                   width_of<T>, scattered ? "scattered" : "coherent", rate(0, 0, false), rate(3, 3, true),
                   rate(12, 3, true), rate(60, 3, true));
    }
}

}  // namespace

int main(int argc, char** argv) {
    const int side = argc > 1 ? std::atoi(argv[1]) : 1024;
    if (side < 1) return 1;
    const TextureMap map = make_texture_map(noise(side));
    fmt::print("million lookups a second, one thread, {} x {} texels\n", side, side);
    report<float>(map, side);
    report<Lane<float, 8>>(map, side);
    report<Lane<float, 16>>(map, side);
}
