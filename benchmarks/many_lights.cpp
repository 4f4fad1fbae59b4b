// What many lights cost, and how right they are for the time: the same light from 1 to 1000000 lamps.
//
//   many_lights [SPP]      samples a pixel of the timed picture, 16 by default
//
// Lamps of one strength together hang over a table of balls, in a square: rectangles, balls and points with falloff.
// Up to 16 are asked at every hit, of more the light tree draws four. One thread, CPU seconds; nanoseconds a light
// sample are those of the whole render. The error is against a picture of 64 times as many samples; error *
// sqrt(seconds) compares methods at equal time.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <random>

#include "drt/render/render.h"

namespace {

using namespace drt;

constexpr int width = 160, height = 120;

Body ball(int i) {
    Body b;
    b.shape = Sphere{{1.2 * (i % 4) - 1.8, 0.5, 1.2 * (i / 4) - 1.8}, 0.5};
    b.material = "grey";
    return b;
}

/// Side by side over a square of 6 x 6, at different heights.
Light lamp(int i, int count) {
    const int rows = int(std::ceil(std::sqrt(double(count))));
    const double cell = 6.0 / rows, x = (i % rows + 0.5) * cell - 3, z = (i / rows + 0.5) * cell - 3;
    const double y = 2.5 + 0.5 * std::fmod(i * 0.618034, 1.0), size = 0.3 * cell;
    Light l;
    const double area = size * size, strength = 60.0 / count;  // W / sr
    if (i % 3 == 0) {
        l.shape = RectLight{{x - size / 2, y, z - size / 2}, {size, 0, 0}, {0, 0, size}};
        l.color = Color(float(strength / area));
    } else if (i % 3 == 1) {
        l.shape = SphereLight{{x, y, z}, size / 2};
        l.color = Color(float(strength / (area * 0.785398)));
    } else {
        l.shape = PointLight{{x, y, z}};
        l.color = Color(float(strength));
    }
    return l;
}

SceneDesc scene(int lights) {
    SceneDesc s;
    s.render.width = width;
    s.render.height = height;
    Material grey;
    grey.name = "grey";
    grey.diffuse = Color(0.7f);
    grey.ambient = Color(0.0f);
    s.materials = {grey};
    Body floor;
    floor.shape = Plane{};
    floor.material = "grey";
    s.bodies = {floor};
    for (int i = 0; i < 16; ++i) s.bodies.push_back(ball(i));
    for (int i = 0; i < lights; ++i) s.lights.push_back(lamp(i, lights));
    Camera camera;
    camera.positions = {{0, 5, 6}};
    camera.targets = {{0, 0.3, 0}};
    s.cameras = {camera};
    return s;
}

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

struct Timed {
    RenderResult result;
    double seconds;
};

/// The best of a few runs: other programs only ever add to the time.
Timed timed_render(const RenderPlan& plan, int spp, int runs) {
    RenderOptions options;
    options.spp = spp;
    options.threads = 1;
    double best = 1e30;
    for (;;) {
        const double start = cpu_seconds();
        RenderResult result = render(plan, options);
        best = std::min(best, cpu_seconds() - start);
        if (--runs == 0) return {std::move(result), best};
    }
}

double relative_rms(const Image& a, const Image& truth) {
    double sum = 0, mean = 0;
    for (size_t i = 0; i < a.data.size(); i += 4) {
        const double d = double(a.data[i]) - double(truth.data[i]);
        sum += d * d;
        mean += double(truth.data[i]);
    }
    const double n = double(a.data.size()) / 4;
    return std::sqrt(sum / n) / (mean / n);
}

void measure(int lights, int spp) {
    const SceneDesc description = scene(lights);
    const double start = cpu_seconds();
    const RenderPlan plan = compile(description, {});
    const double compiled = cpu_seconds() - start;
    const Timed picture = timed_render(plan, spp, 5);
    SceneDesc other = description;  // other seeds, so that their errors have nothing in common
    other.render.seed = 1;
    const Timed truth = timed_render(compile(other, {}), 64 * spp, 1);
    const double error = relative_rms(resolve(picture.result.film), resolve(truth.result.film));
    const double rays = double(picture.result.counters.shadow_rays);
    fmt::print("{:8} {:9.2f} s {:9.3f} s {:12.1f} ns {:9.3f} % {:12.4f}\n", lights, compiled, picture.seconds,
               picture.seconds / rays * 1e9, 100 * error, 100 * error * std::sqrt(picture.seconds));
}

}  // namespace

int main(int argc, char** argv) {
    const int spp = argc > 1 ? std::atoi(argv[1]) : 16;
    fmt::print("{:>8} {:>11} {:>11} {:>15} {:>11} {:>12}\n", "lights", "compile", "render", "a light sample", "error",
               "error*sqrt(s)");
    for (const int lights : {1, 8, 9, 16, 17, 1000, 1000000}) measure(lights, spp);
}
