// How far is the renderer from the limit? One run, one thread, side by side, the median of several rounds:
//   drt        the whole render
//   queries    a bare loop of Embree packet queries over the very rays that the render traced
//   one ray    rtcIntersect1 against SPHERE_POINT with scalar shading (direct light only)
// With --profile it only renders the first scene, for a profiler to watch.
// Goals: drt <= 2 x queries with direct light, <= 2.5 x with glossy balls, lens and motion; drt >= 5 x faster than one
// ray.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <string_view>
#include <vector>

#include "ball_scene.h"
#include "drt/base/flush_denormals.h"
#include "drt/render/render.h"
#include "recorder.h"
#include "scalar_renderer.h"

namespace drt {
namespace {

constexpr int spp = 16;
constexpr int rounds = 21;
constexpr int scalar_rounds = 5;  // ten times slower

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

double median(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + std::ptrdiff_t(v.size() / 2), v.end());
    return v[v.size() / 2];
}

// Round by round, so that what disturbs the machine for a while disturbs both: the median, and the quartiles.
std::string ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> r;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) r.push_back(a[i] / b[i]);
    std::sort(r.begin(), r.end());
    return fmt::format("{:.2f} ({:.2f} .. {:.2f})", r[r.size() / 2], r[r.size() / 4], r[r.size() * 3 / 4]);
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
    std::vector<double> render_seconds, queries_seconds, scalar_seconds;
    std::size_t hits = 0;
    Color mean;
    for (int i = 0; i < rounds; ++i) {
        render_seconds.push_back(render(plan, one_thread()).seconds);
        queries_seconds.push_back(seconds([&] { hits = replay(*packet_scene, packets); }));
        if (scalar && i < scalar_rounds)
            scalar_seconds.push_back(
                seconds([&] { mean = render_one_ray_at_a_time(scene, bodies, *point_scene, spp); }));
    }
    std::size_t rays = 0;
    for (const RecordedPacket& p : packets)
        for (const int v : p.valid) rays += v != 0;
    const double samples = double(plan.width) * plan.height * spp;
    fmt::print("{:28} drt {:7.2f} Msamples/s  queries alone {:6.1f} Mrays/s ({} hits)  drt/queries {}", name,
               samples / median(render_seconds) * 1e-6, double(rays) / median(queries_seconds) * 1e-6, hits,
               ratio(render_seconds, queries_seconds));
    if (scalar) fmt::print("  one ray/drt {} (mean {:.4f})", ratio(scalar_seconds, render_seconds), luminance(mean));
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
    fmt::print("{} lanes, 640x480, {} spp, one thread, median (quartiles) of {} rounds\n", packet_width, spp, rounds);
    measure("direct light", {}, true);
    measure("glossy, lens, motion", {true, true, true}, false);
}
