#include "physics.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "drt/bake/cache.h"
#include "drt/plan/exposure.h"

namespace drt {

namespace {

// The latest scene time that a frame shows.
struct ShownTime {
    int frame = 0;
    double time = 0;
};

std::vector<ShownTime> shown_times(const RenderArguments& a, const SceneDesc& scene) {
    std::vector<ShownTime> out;
    for (const int frame : a.frames) {
        const Exposure e = exposure_of_frame(scene, frame, a.plan.camera);
        out.push_back({frame, std::max(e.time0, e.time1)});
    }
    return out;
}

// The first of the frames, in their order, that shows what is later than `time`; and how many there are.
std::string frames_beyond(const std::vector<ShownTime>& shown, double time) {
    const auto is_beyond = [&](const ShownTime& s) { return s.time > time; };
    const auto first = std::find_if(shown.begin(), shown.end(), is_beyond);
    if (first == shown.end()) return {};
    const auto count = std::count_if(first, shown.end(), is_beyond);
    return fmt::format("{} of {} frames show later times, the first is frame {} with t = {:.6g} s", count, shown.size(),
                       first->frame, first->time);
}

Diagnostics warnings(const SceneDesc& scene, const BakeReport& r, const std::vector<ShownTime>& shown) {
    Diagnostics out;
    if (r.dynamic_bodies == 0) return out;
    if (const std::string frames = frames_beyond(shown, r.end); !frames.empty())
        out.push_back(
            {Severity::warning,
             scene.sources.find("simulation.end"),
             fmt::format("the simulation ends at t = {:.6g} s, then its bodies stand still; {}", r.end, frames),
             {},
             {},
             {}});
    if (r.trusted_until >= r.end) return out;
    if (const std::string frames = frames_beyond(shown, r.trusted_until); !frames.empty())
        out.push_back(
            {Severity::warning,
             scene.sources.find("simulation"),
             fmt::format("the motion can be trusted until t = {:.6g} s, then {}; {}", r.trusted_until,
                         r.is_chaotic ? "the last digits of the description decide" : "shorter steps still change it",
                         frames),
             {},
             {},
             {}});
    return out;
}

void tell(Console& console, const CachedMotion& c, double seconds) {
    if (c.found) return console.verbose(fmt::format("physics: motion found in {}", c.file));
    const std::string why = c.file.empty() ? "" : fmt::format(" ({}: {})", c.file, c.found_not_because);
    console.verbose(fmt::format("physics: computed in {:.3g} s{}\n{}", seconds, why, to_text(c.motion.report)));
    if (c.kept_not_because.empty()) return;
    console.print({{Severity::note,
                    {},
                    fmt::format("the motion is not kept in {}: {}", c.file, c.kept_not_because),
                    {},
                    {},
                    {}}});
}

}  // namespace

std::optional<SceneDesc> bake_physics(const RenderArguments& a, const SceneDesc& scene, Console& console) {
    if (!has_physics(scene)) return {};
    const std::vector<ShownTime> shown = shown_times(a, scene);
    const auto later = [](const ShownTime& l, const ShownTime& r) { return l.time < r.time; };
    const BakeInput input = bake_input(scene, std::max_element(shown.begin(), shown.end(), later)->time);
    const auto begin = std::chrono::steady_clock::now();
    CachedMotion motion = cached_motion(input, a.bake_cache);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    tell(console, motion, seconds.count());
    Baked baked = with_motion(scene, input, std::move(motion.motion));
    console.print(baked.notes);
    console.print(warnings(scene, baked.report, shown));
    return std::move(baked.scene);
}

}  // namespace drt
