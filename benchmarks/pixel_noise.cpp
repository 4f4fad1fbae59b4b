// How much of a picture's noise a blur leaves, against what it would leave if neighbours were independent.
//
//   pixel_noise SCENE [SEEDS [SPP [WIDTH HEIGHT]]]      32 seeds, powers of 2 up to 64 samples, 96 x 72 pixels
//
// Variances over seeds, averaged over pixels, so there is no need for a reference. `blur` is the deviation that is left
// after a Gaussian of so many pixels, in units of what it would leave of independent pixels; `est/true` the error that
// the replicates estimate, against the one that the seeds show.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>
#include <vector>

#include "drt/formats/formats.h"
#include "drt/render/render.h"

namespace {

using namespace drt;

constexpr double sigmas[] = {1, 2};  ///< of the blurs, in pixels

/// One channel.
struct Plane {
    int width = 0, height = 0;
    std::vector<double> v;
};

std::vector<double> gaussian(double sigma) {
    const int radius = int(std::ceil(3 * sigma));
    std::vector<double> kernel;
    double sum = 0;
    for (int i = -radius; i <= radius; ++i) sum += kernel.emplace_back(std::exp(-i * i / (2 * sigma * sigma)));
    for (double& v : kernel) v /= sum;
    return kernel;
}

/// Along rows, where the whole kernel fits; and transposed: twice is a blur of the picture.
Plane blur_rows(const Plane& in, const std::vector<double>& kernel) {
    Plane out{in.height, in.width - int(kernel.size()) + 1, {}};
    for (int x = 0; x < out.height; ++x)
        for (int y = 0; y < out.width; ++y) {
            double sum = 0;
            for (size_t i = 0; i < kernel.size(); ++i) sum += kernel[i] * in.v[size_t(y * in.width + x) + i];
            out.v.push_back(sum);
        }
    return out;
}

Plane blur(const Plane& in, const std::vector<double>& kernel) { return blur_rows(blur_rows(in, kernel), kernel); }

/// Of pictures with different seeds.
struct Spread {
    int count = 0;
    Plane sum, squares;

    void add(const Plane& picture) {
        if (count++ == 0) sum = squares = {picture.width, picture.height, std::vector<double>(picture.v.size())};
        for (size_t i = 0; i < picture.v.size(); ++i)
            sum.v[i] += picture.v[i], squares.v[i] += picture.v[i] * picture.v[i];
    }
    Plane variance() const {
        Plane out = squares;
        for (size_t i = 0; i < out.v.size(); ++i) out.v[i] = (out.v[i] - sum.v[i] * sum.v[i] / count) / (count - 1);
        return out;
    }
};

double mean(const Plane& p) { return std::accumulate(p.v.begin(), p.v.end(), 0.0) / double(p.v.size()); }

/// All that is known of one number of samples.
struct Level {
    Spread sharp;
    std::array<Spread, std::size(sigmas)> blurred;
    double squared_estimates = 0;

    void add(const Film& film) {
        const Image image = resolve(film);
        Plane green{image.width, image.height, {}};
        for (size_t i = 1; i < image.data.size(); i += size_t(image.channels)) green.v.push_back(double(image.data[i]));
        sharp.add(green);
        for (size_t b = 0; b < blurred.size(); ++b) blurred[b].add(blur(green, gaussian(sigmas[b])));
        const double rmse = estimate_error(film).rmse;
        squared_estimates += rmse * rmse;
    }
};

void print(int spp, const Level& level) {
    const Plane variance = level.sharp.variance();
    fmt::print("{:5} spp  rms {:.3e}", spp, std::sqrt(mean(variance)));
    for (size_t b = 0; b < level.blurred.size(); ++b) {
        std::vector<double> squares = gaussian(sigmas[b]);
        for (double& v : squares) v *= v;
        const double independent = mean(blur(variance, squares));
        fmt::print("  blur {}: {:.3f}", sigmas[b], std::sqrt(mean(level.blurred[b].variance()) / independent));
    }
    fmt::print("  est/true {:.3f}\n", std::sqrt(level.squared_estimates / level.sharp.count / mean(variance)));
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    if (argc < 2) return 2;
    SceneDesc scene = read_scene(argv[1]).scene;
    const int seeds = number(2, 32);
    RenderOptions options;
    options.spp = number(3, 64);
    scene.render.width = number(4, 96);
    scene.render.height = number(5, 72);
    std::vector<Level> levels(size_t(std::log2(options.spp) + 1e-9));  // 2, 4, ... samples
    for (int seed = 1; seed <= seeds; ++seed) {
        scene.render.seed = std::uint32_t(1000 + seed);
        RenderEvents events;
        size_t next = 0;
        events.pass_done = [&](const Film& film, const Progress& progress) {
            if (next < levels.size() && progress.spp_done == 2 << next) levels[next++].add(film);
        };
        render(compile(scene, {}), options, events);
    }
    for (size_t i = 0; i < levels.size(); ++i) print(2 << i, levels[i]);
}
