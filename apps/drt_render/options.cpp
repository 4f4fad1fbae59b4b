#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <map>

#include "../legacy_options.h"
#include "drt/base/version.h"
#include "frames.h"

namespace drt {

namespace {

[[noreturn]] void usage_error(const std::string& what, const std::string& text, const std::string& expected) {
    throw Error(ErrorKind::usage, {{Severity::error, {}, what, text, expected, ""}});
}

double to_number(const std::string& text, const std::string& option, const std::string& expected) {
    double v = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    if (error != std::errc() || end != text.data() + text.size() || !(v >= 0) || v > 1e9)
        usage_error("bad value for " + option, text, expected);
    return v;
}

// "90", "90s", "1.5m", "2h"
double parse_duration(const std::string& text, const std::string& option) {
    static const std::map<char, double> units{{'s', 1}, {'m', 60}, {'h', 3600}};
    const auto unit = text.empty() ? units.end() : units.find(text.back());
    const std::string digits = unit == units.end() ? text : text.substr(0, text.size() - 1);
    return to_number(digits, option, "a duration such as 90, 90s, 1.5m or 2h") *
           (unit == units.end() ? 1 : unit->second);
}

Snapshot parse_snapshot(const std::string& text) {
    const size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {text, 0};
    return {text.substr(0, colon), parse_duration(text.substr(colon + 1), "--snapshot")};
}

void parse_resolution(const std::string& text, Overrides& o) {
    const size_t x = text.find('x');
    const std::string expected = "WIDTHxHEIGHT in pixels, such as 640x480";
    if (x == std::string::npos) usage_error("bad resolution", text, expected);
    o.width = int(to_number(text.substr(0, x), "--resolution", expected));
    o.height = int(to_number(text.substr(x + 1), "--resolution", expected));
}

// The command line as text, before it is taken apart.
struct Texts {
    std::string scene, legacy_scene, frames, frame, time_limit, snapshot, resolution, missing, plan, precision,
        progress;
};

void add_options(CLI::App& app, RenderArguments& a, Texts& t) {
    app.add_option("scene", t.scene, "Scene file: YAML (.yaml, .yml) or legacy text");
    app.add_option("-s,--scene", t.legacy_scene, "The same, as the 2008 program took it");
    app.add_option("-o,--output", a.outputs,
                   "Picture to write: .exr scene-linear, .png .bmp .jpg through the display transform; may be given "
                   "several times; #### or %04d becomes the frame number");
    app.add_option("-f,--frame", t.frame, "Frame to render (default 0)");
    app.add_option("--frames", t.frames, "Frames to render: A-B, A-B:STEP, or a list such as 1-10,20");
    app.add_option("-c,--camera", a.plan.camera, "Camera to use (default: the one that records the frame)");
    app.add_flag("-p,--preview", a.preview, "Leave out all distributed effects");

    app.add_option("--spp", a.overrides.spp, "Samples per pixel")->check(CLI::Range(1, 1 << 24));
    app.add_option("--time-limit", t.time_limit, "Stop a frame after this long: 90, 90s, 1.5m, 2h");
    app.add_option("--seed", a.overrides.seed, "Seed of the sample points");
    app.add_option("--max-depth", a.overrides.max_depth, "Reflections and refractions in a row")
        ->check(CLI::Range(0, 10000));
    app.add_option("-r,--resolution", t.resolution, "Picture size, WIDTHxHEIGHT");
    app.add_option("--exposure", a.display.exposure, "Stops, for display pictures (PNG, JPEG, BMP)");
    app.add_option("--snapshot", t.snapshot,
                   "FILE[:SECONDS]: write the picture so far, every SECONDS or after each pass");
    app.add_option("--missing-textures", t.missing, "error (default) or checker: render on with a checker")
        ->check(CLI::IsMember({"error", "checker"}));

    app.add_option("-t,--threads", a.threads, "Threads (0 = all)")->check(CLI::Range(0, 1024));
    app.add_option("--plan", t.plan, "auto (default) or general: leave nothing out")
        ->check(CLI::IsMember({"auto", "general"}));
    app.add_option("--precision", t.precision, "auto (default), single or double geometry")
        ->check(CLI::IsMember({"auto", "single", "double"}));
    app.add_flag("--explain", a.explain, "Say what the plan leaves out and why");
    app.add_flag("--check", a.check, "Read and check the scene, render nothing");

    app.add_option("--progress", t.progress, "auto (default), bar, plain or none")
        ->check(CLI::IsMember({"auto", "bar", "plain", "none"}));
    app.add_flag("-q,--quiet", a.quiet, "Print errors only");
    app.add_flag("-v,--verbose", a.verbose, "Print notes and per-stage times");
    app.set_version_flag("--version", fmt::format("drt-render {} ({})", version(), build_isa()));
    add_legacy_options(app, a.legacy);
}

void take_texts(RenderArguments& a, const Texts& t) {
    if (!t.scene.empty() && !t.legacy_scene.empty()) usage_error("two scene files", t.legacy_scene, "one");
    a.scene = t.scene.empty() ? t.legacy_scene : t.scene;
    if (a.scene.empty()) usage_error("no scene file", "", "drt-render scene.yaml -o out.exr");
    if (!t.frame.empty() && !t.frames.empty()) usage_error("both --frame and --frames", t.frames, "one of them");
    if (!t.frame.empty() || !t.frames.empty()) a.frames = parse_frames(t.frame.empty() ? t.frames : t.frame);
    if (!t.time_limit.empty()) a.time_limit = parse_duration(t.time_limit, "--time-limit");
    if (!t.snapshot.empty()) a.snapshot = parse_snapshot(t.snapshot);
    if (!t.resolution.empty()) parse_resolution(t.resolution, a.overrides);
    a.plan.checker_for_missing_textures = t.missing == "checker";
    a.plan.general = t.plan == "general";
    using Precision = PlanOptions::Precision;
    a.plan.precision = t.precision == "single"   ? Precision::single
                       : t.precision == "double" ? Precision::double_
                                                 : Precision::automatic;
    a.progress = t.progress == "bar"     ? ProgressStyle::bar
                 : t.progress == "plain" ? ProgressStyle::plain
                 : t.progress == "none"  ? ProgressStyle::none
                                         : ProgressStyle::automatic;
    if (a.outputs.empty() && !a.check && !a.explain)
        usage_error("no output file", "", "-o out.exr (or --check, --explain)");
}

}  // namespace

std::optional<RenderArguments> parse_arguments(int argc, char** argv, int* code) {
    CLI::App app{"drt-render: distributed ray tracing of a scene to a picture"};
    app.failure_message(CLI::FailureMessage::simple);
    RenderArguments a;
    Texts t;
    add_options(app, a, t);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {  // --help, --version
        *code = app.exit(e);
        return {};
    } catch (const CLI::ParseError& e) {
        throw Error(ErrorKind::usage, e.what() + std::string("; --help lists the options"));
    }
    take_texts(a, t);
    return a;
}

}  // namespace drt
