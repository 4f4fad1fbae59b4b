// How long very many balls take to read, build and render, and how much memory at most.
//
//   million_spheres [set|bodies] [COUNT] [single|double]      set, 1000000 and single by default
//
// `set` describes them as one sphere_set, `bodies` as a YAML body each. The picture is small (320 x 240, 4 samples): it
// is the scene that is measured. The peak is the whole process's.

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "drt/formats/formats.h"
#include "drt/render/render.h"

namespace {

using namespace drt;
namespace fs = std::filesystem;

struct Arguments {
    bool set = true;
    int count = 1000000;
    PlanOptions::Precision precision = PlanOptions::Precision::single;
};

/// A folder that is gone with the program.
struct Scratch {
    fs::path path = fs::temp_directory_path() / fmt::format("drt-million-{}", getpid());
    Scratch() { fs::create_directory(path); }
    ~Scratch() { fs::remove_all(path); }
};

/// Balls of random size in a cube that is seen from outside, each written as `line` says (x, y, z, radius).
void write_balls(std::ostream& out, int count, std::string_view line) {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) { return low + (high - low) * double(random()) * 0x1p-32; };
    for (int i = 0; i < count; ++i) {
        const double x = between(-10, 10), y = between(-10, 10), z = between(-10, 10), radius = between(0.01, 0.05);
        out << fmt::format(fmt::runtime(line), x, y, z, radius);
    }
}

fs::path write_scene(const fs::path& folder, const Arguments& a) {
    const fs::path path = folder / "scene.yaml";
    std::ofstream scene(path);
    scene << "drt: 1\n"
             "render: {width: 320, height: 240, spp: 4}\n"
             "background: 0.2\n"
             "materials: [{name: grey, diffuse: 0.7}]\n"
             "lights: [{type: rectangle, corner: [-5, 20, -5], edge_x: [10, 0, 0], edge_y: [0, 0, 10], color: 10}]\n"
             "cameras: [{position: [0, 5, 30]}]\n"
             "bodies:\n";
    if (a.set) {
        scene << "  - {type: sphere_set, file: balls.txt, material: grey}\n";
        std::ofstream set(folder / "balls.txt");
        write_balls(set, a.count, "{:.6g} {:.6g} {:.6g} {:.4g}\n");
    } else {
        write_balls(scene, a.count,
                    "  - {{type: sphere, center: [{:.6g}, {:.6g}, {:.6g}], radius: {:.4g}, material: grey}}\n");
    }
    return path;
}

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return double(usage.ru_maxrss) * 1024e-6;
}

/// Runs one step and prints what it took.
template <class Step>
auto measured(const char* name, Step step) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    auto result = step();
    const double cpu = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print("{:32} {:6.2f} s   {:6.2f} s of CPU   peak so far {:4.0f} MB\n", name, seconds.count(), cpu,
               peak_megabytes());
    return result;
}

void run(const Arguments& a) {
    const Scratch scratch;
    const fs::path path = write_scene(scratch.path, a);
    fmt::print("{} balls, {}, {}; before reading: {:.0f} MB\n", a.count, a.set ? "sphere_set" : "YAML bodies",
               a.precision == PlanOptions::Precision::single ? "float" : "double", peak_megabytes());
    const SceneRead read = measured("read the scene", [&] { return read_scene(path.string()); });
    if (a.set)
        measured("read the set, by itself",
                 [&] { return read_sphere_set((scratch.path / "balls.txt").string()).size(); });
    PlanOptions options;
    options.precision = a.precision;
    const RenderPlan plan = measured("compile (reads sets, builds)", [&] { return compile(read.scene, options); });
    RenderOptions render_options;
    render_options.spp = read.scene.render.spp;
    const RenderResult result = measured("render", [&] { return render(plan, render_options); });
    fmt::print("scene {:.0f} MB, film {:.0f} MB; {} threads\n", double(plan.memory) * 1e-6,
               double(result.film.memory()) * 1e-6, result.threads);
}

}  // namespace

int main(int argc, char** argv) {
    Arguments a;
    const auto argument = [&](int i) { return std::string(i < argc ? argv[i] : ""); };
    a.set = argument(1) != "bodies";
    if (argc > 2) a.count = std::atoi(argv[2]);
    if (argument(3) == "double") a.precision = PlanOptions::Precision::double_;
    try {
        run(a);
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}\n", e.what());
        return 1;
    }
}
