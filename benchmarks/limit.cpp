// How far is the renderer from the limit? One run, one thread, side by side, the best of several rounds:
//   drt        the whole render
//   queries    a bare loop of Embree packet queries over the very rays that the render traced
//   one ray    rtcIntersect1 against SPHERE_POINT with scalar shading (direct light only)
// With --profile it only renders the first scene, for a profiler to watch.
// Goals: drt <= 2 x queries with direct light, <= 2.5 x with glossy balls, lens and motion; drt >= 5 x faster than one
// ray.

#include <fmt/format.h>

#include <chrono>
#include <limits>
#include <string_view>

#include "ball_scene.h"
#include "drt/render/render.h"
#include "recorder.h"
#include "scalar_renderer.h"

namespace drt {
namespace {

constexpr int spp = 16;
constexpr int rounds = 9;

template <class Work>
double seconds(Work work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

RenderOptions one_thread() {
    RenderOptions o;
    o.spp = spp;
    o.threads = 1;
    return o;
}

void measure(const char* name, const BallSceneOptions& options, bool scalar) {
    const SceneDesc scene = ball_scene(options);
    const RenderPlan plan = compile(scene, {});
    const Vec3d origin = std::visit([](const auto& w) { return w->origin; }, plan.world);
    std::vector<RecordedPacket> packets;
    start_recording(packets);
    render(plan, one_thread());
    stop_recording();

    const BareBodies bodies = bare_bodies(scene, origin);
    const auto packet_scene = build_packet_scene(bodies);
    const auto point_scene = build_point_scene(bodies);
    double best_render = std::numeric_limits<double>::infinity(), best_queries = best_render, best_scalar = best_render;
    std::size_t hits = 0;
    Color mean;
    for (int i = 0; i < rounds; ++i) {
        best_render = std::min(best_render, render(plan, one_thread()).seconds);
        best_queries = std::min(best_queries, seconds([&] { hits = replay(*packet_scene, packets); }));
        if (scalar)
            best_scalar = std::min(best_scalar,
                                   seconds([&] { mean = render_one_ray_at_a_time(scene, bodies, *point_scene, spp); }));
    }
    std::size_t rays = 0;
    for (const RecordedPacket& p : packets)
        for (const int v : p.valid) rays += v != 0;
    const double samples = double(plan.width) * plan.height * spp;
    fmt::print("{:28} drt {:7.2f} Msamples/s  queries alone {:6.1f} Mrays/s ({} hits)  drt/queries {:.2f}", name,
               samples / best_render * 1e-6, double(rays) / best_queries * 1e-6, hits, best_render / best_queries);
    if (scalar) fmt::print("  one ray/drt {:.2f} (mean {:.4f})", best_scalar / best_render, luminance(mean));
    fmt::print("\n");
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    using namespace drt;
    if (argc > 1 && std::string_view(argv[1]) == "--profile") {  // only the render, for a profiler
        const RenderPlan plan = compile(ball_scene({}), {});
        for (int i = 0; i < rounds; ++i) render(plan, one_thread());
        return 0;
    }
    fmt::print("{} lanes, 640x480, {} spp, one thread, best of {} rounds\n", packet_width, spp, rounds);
    measure("direct light", {}, true);
    measure("glossy, lens, motion", {true, true, true}, false);
}
