// drt-render: a scene file becomes a picture. Parse, read, bake physics, compile, render, write.

#include <fmt/format.h>

#include <csignal>
#include <new>
#include <optional>
#include <string>

#include "apps/exit_codes.h"
#include "apps/standard_streams.h"
#include "console.h"
#include "drt/plan/exposure.h"
#include "drt/plan/texture_cache.h"
#include "drt/render/render.h"
#include "drt/scene/preview.h"
#include "options.h"
#include "output.h"
#include "physics.h"
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
    Diagnostics wrong = validate(scene);
    std::erase_if(wrong, [](const Diagnostic& d) { return d.severity != Severity::error; });
    for (Diagnostic& d : wrong) d.where = {};  // the scene was valid: it is the command line's doing
    if (!wrong.empty()) throw Error(ErrorKind::usage, wrong);
    return scene;
}

// What is rendered, the same for every frame.
struct Job {
    const RenderArguments& arguments;
    const SceneDesc& scene;
    Console& console;
    std::string hash;
    TextureCache& textures;
};

RenderPlan plan_frame(const Job& job, int frame) {
    const RenderArguments& a = job.arguments;
    PlanOptions options = a.plan;
    options.frame = frame;
    RenderPlan plan = compile(job.scene, options, job.textures);
    job.console.print(plan.notes);
    if (a.explain)
        write_stdout((a.frames.size() > 1 ? fmt::format("frame {}:\n", frame) : "") + explain_text(plan.explanation));
    return plan;
}

// Tells once that a signal has arrived. Handlers may not print: whoever renders does.
class StopNote {
public:
    explicit StopNote(Console& console) : console_(console) {}
    void print_if_stopping() {
        if (!stop_requested() || printed_) return;
        printed_ = true;
        console_.note("stopping: finishing the tiles at hand");
    }

private:
    Console& console_;
    bool printed_ = false;
};

RenderEvents events_for(const Job& job, const OutputInfo& info, StopNote& stop_note) {
    RenderEvents events;
    events.progress = [&job, &stop_note](const Progress& p) {
        job.console.progress(p);
        stop_note.print_if_stopping();
    };
    if (const auto snapshot = frame_snapshot(job.arguments, info.frame))
        events.pass_done = [&job, info, writer = SnapshotWriter(*snapshot, job.arguments.display)](
                               const Film& film, const Progress& p) mutable {
            // A snapshot that fails costs nobody a render: the final write will fail or succeed on its own.
            try {
                writer.pass_done(film, p, info);
            } catch (const Error& e) {
                job.console.note(std::string("warning: snapshot: ") + e.what());
            }
        };
    return events;
}

// Every picture is tried: one full disk must not cost what another has room for. Throws the first failure.
void write_outputs(const Job& job, const OutputInfo& info, const RenderResult& result) {
    const Image picture = resolve(result.film);
    std::optional<Error> failure;
    for (const std::string& path : output_paths(job.arguments, info.frame)) {
        try {
            write_image(path, picture, metadata(info, result), job.arguments.display);
            job.console.note(fmt::format("wrote {}", path));
        } catch (const Error& e) {
            if (failure)
                job.console.note(e.what());
            else
                failure = e;
        }
    }
    if (failure) throw Error(*failure);
}

void render_frame(const Job& job, int frame) {
    const RenderArguments& a = job.arguments;
    for (const std::string& path : output_paths(a, frame)) check_writable(path);
    const RenderPlan plan = plan_frame(job, frame);
    RenderOptions options;
    options.spp = job.scene.render.spp;
    options.time_limit = a.time_limit;
    options.threads = a.threads;
    options.stop = &stop_requested();
    const OutputInfo info{job.hash, frame, &plan, job.scene.render.seed};
    StopNote stop_note(job.console);
    const RenderResult result = render(plan, options, events_for(job, info, stop_note));
    job.console.end_progress();
    if (result.stopped_by == StopReason::interrupted) stop_note.print_if_stopping();
    if (result.counters.camera_rays == 0) {  // stopped before the first ray: an old picture is worth more than none
        job.console.note("interrupted before the first sample; nothing written");
        return;
    }
    write_outputs(job, info, result);
    job.console.note(summary(result, a.verbose));
    for (const std::string& fault : faults(result)) job.console.alert(fault);
}

void run_frames(const Job& job) {
    const RenderArguments& a = job.arguments;
    for (const int frame : a.frames) exposure_of_frame(job.scene, frame, a.plan.camera);  // throws if none records it
    if (a.check || a.outputs.empty()) {
        for (size_t i = 0; i < (a.explain ? a.frames.size() : 1); ++i) plan_frame(job, a.frames[i]);
        if (a.check)
            job.console.note(fmt::format("ok: {} (bodies: {}, lights: {}, cameras: {}, frames: {})", a.scene,
                                         job.scene.bodies.size(), job.scene.lights.size(), job.scene.cameras.size(),
                                         a.frames.size()));
        return;
    }
    let_signals_stop_rendering();
    for (const int frame : a.frames) {
        render_frame(job, frame);
        if (received_signal() != 0) return;
    }
}

int run_program(int argc, char** argv) {
    prepare_standard_streams();
    install_signal_handlers();
    const auto parsed = parse_arguments(argc, argv);
    if (!parsed) return exit_ok;
    const RenderArguments& a = *parsed;
    Console console(a.quiet, a.verbose, a.progress);
    const FileSet outputs = check_outputs(a);
    const SceneRead read = read_scene(a.scene, a.legacy);
    console.print(read.notes);
    check_inputs_kept(outputs, read);
    const SceneDesc scene = apply(a, read.scene);
    std::optional<SceneDesc> baked;
    if (!a.check || a.explain) baked = bake_physics(a, scene, console);
    TextureCache textures;
    run_frames({a, baked ? *baked : scene, console, scene_hash(scene), textures});
    if (received_signal() == SIGTERM) return exit_terminated;
    return received_signal() != 0 ? 128 + received_signal() : exit_ok;
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    try {
        return drt::run_program(argc, argv);
    } catch (const drt::Error& e) {
        drt::write_stderr(std::string(e.what()) + '\n');
        return drt::exit_code(e.kind());
    } catch (const std::bad_alloc&) {
        drt::write_stderr("error: out of memory\n");
        return drt::exit_code(drt::ErrorKind::memory);
    } catch (const std::exception& e) {
        drt::write_stderr(std::string("internal error: ") + e.what() + '\n');
        return drt::exit_internal;
    }
}
