// drt-render: a scene file becomes a picture. Parse, read, compile, render, write.

#include <fmt/format.h>

#include <csignal>
#include <new>

#include "../exit_codes.h"
#include "console.h"
#include "drt/base/version.h"
#include "drt/render/render.h"
#include "drt/scene/preview.h"
#include "frames.h"
#include "options.h"
#include "output.h"
#include "signals.h"

namespace drt {
namespace {

SceneDesc apply(const RenderArguments& a, SceneDesc scene) {
    if (a.preview) scene = without_distributed_effects(scene);
    RenderSettings& r = scene.render;
    r.spp = a.overrides.spp.value_or(r.spp);
    r.seed = a.overrides.seed.value_or(r.seed);
    r.max_depth = a.overrides.max_depth.value_or(r.max_depth);
    r.width = a.overrides.width.value_or(r.width);
    r.height = a.overrides.height.value_or(r.height);
    const Diagnostics wrong = validate(scene);
    if (has_errors(wrong)) throw Error(ErrorKind::usage, wrong);
    return scene;
}

RenderEvents events_for(const RenderArguments& a, const OutputInfo& info, Console& console) {
    RenderEvents events;
    events.progress = [&console](const Progress& p) { console.progress(p); };
    if (a.snapshot)
        events.pass_done = [&console, info, writer = SnapshotWriter(*a.snapshot, a.display)](
                               const Film& film, const Progress& p) mutable {
            // A snapshot that fails costs nobody a render: the final write will fail or succeed on its own.
            try {
                writer.pass_done(film, p, info);
            } catch (const Error& e) {
                console.note(std::string("warning: snapshot: ") + e.what());
            }
        };
    return events;
}

void render_frame(const RenderArguments& a, const SceneDesc& scene, int frame, Console& console) {
    PlanOptions plan_options = a.plan;
    plan_options.frame = frame;
    const RenderPlan plan = compile(scene, plan_options);
    console.print(plan.notes);
    if (a.explain) fmt::print("{}", explain_text(plan.explanation));
    if (a.outputs.empty()) return;
    RenderOptions options;
    options.spp = scene.render.spp;
    options.time_limit = a.time_limit;
    options.threads = a.threads;
    options.stop = &stop_requested();
    OutputInfo info{scene_hash(scene), frame, &plan, scene.render.seed};
    const RenderResult result = render(plan, options, events_for(a, info, console));
    console.end_progress();
    for (const std::string& pattern : a.outputs) {
        const std::string path = frame_path(pattern, frame, a.frames.size() > 1);
        write_image(path, resolve(result.film), metadata(info, result), a.display);
        console.note(fmt::format("wrote {}", path));
    }
    console.note(summary(plan, result, a.verbose));
}

int run_program(int argc, char** argv) {
    int code = exit_ok;
    const auto parsed = parse_arguments(argc, argv, &code);
    if (!parsed) return code;
    const RenderArguments& a = *parsed;
    Console console(a.quiet, a.verbose, a.progress);
    for (const std::string& o : a.outputs)
        for (const int f : a.frames) check_writable(frame_path(o, f, a.frames.size() > 1));
    if (a.snapshot) check_writable(a.snapshot->path);
    const SceneRead read = read_scene(a.scene, a.legacy);
    console.print(read.notes);
    const SceneDesc scene = apply(a, read.scene);
    if (a.check) return exit_ok;
    install_signal_handlers();
    for (const int frame : a.frames) {
        render_frame(a, scene, frame, console);
        if (received_signal() == SIGTERM) return exit_terminated;
        if (received_signal() != 0) return 128 + received_signal();
    }
    return exit_ok;
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    try {
        return drt::run_program(argc, argv);
    } catch (const drt::Error& e) {
        fmt::print(stderr, "{}\n", e.what());
        return drt::exit_code(e.kind());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "error: out of memory\n");
        return drt::exit_code(drt::ErrorKind::memory);
    } catch (const std::exception& e) {
        fmt::print(stderr, "internal error: {}\n", e.what());
        return drt::exit_internal;
    }
}
