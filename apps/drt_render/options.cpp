#include "options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <map>

#include "apps/command_line.h"
#include "apps/legacy_options.h"
#include "drt/bake/cache.h"
#include "drt/base/version.h"
#include "drt/scene/scene_fields.h"
#include "frames.h"

namespace drt {

namespace {

[[noreturn]] void usage_error(const std::string& what, const std::string& text, const std::string& expected) {
    throw Error(ErrorKind::usage, {{Severity::error, {}, what, text, expected, ""}});
}

template <class T>
std::optional<T> read_number(const std::string& text) {
    T v{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return v;
}

template <class T>
T to_number(const std::string& text, T least, T most, const std::string& option) {
    const auto v = read_number<T>(text);
    if (!v || !(*v >= least && *v <= most))
        usage_error("bad value for " + option, text, fmt::format("a number from {} to {}", least, most));
    return *v;
}

// "90", "90s", "1.5m", "2h" in seconds.
std::optional<double> read_duration(const std::string& text) {
    static const std::map<char, double> units{{'s', 1}, {'m', 60}, {'h', 3600}};
    const auto unit = text.empty() ? units.end() : units.find(text.back());
    const auto v = read_number<double>(unit == units.end() ? text : text.substr(0, text.size() - 1));
    if (!v || !(*v >= 0 && *v <= 1e9)) return {};
    return *v * (unit == units.end() ? 1 : unit->second);
}

double parse_time_limit(const std::string& text) {
    const auto seconds = read_duration(text);
    if (!seconds || *seconds == 0)
        usage_error("bad value for --time-limit", text, "a duration > 0 such as 90, 90s, 1.5m or 2h");
    return *seconds;
}

// What follows the last colon is the interval; but "a:b.png" and "a:b/c.png" are paths.
Snapshot parse_snapshot(const std::string& text) {
    const size_t colon = text.rfind(':');
    if (colon == std::string::npos) return {text, 0};
    const std::string rest = text.substr(colon + 1);
    if (const auto interval = read_duration(rest)) return {text.substr(0, colon), *interval};
    if (rest.find_first_of("./") == std::string::npos)
        usage_error("bad value for --snapshot", text, "FILE or FILE:SECONDS, such as preview.png:10");
    return {text, 0};
}

void parse_resolution(const std::string& text, Overrides& o) {
    const size_t x = std::min(text.find('x'), text.size());
    o.width = read_number<int>(text.substr(0, x));
    o.height = read_number<int>(text.substr(std::min(x + 1, text.size())));
    const auto fits = [](const std::optional<int>& side) { return side && *side >= 1 && *side <= largest_image_side; };
    if (!fits(o.width) || !fits(o.height))
        usage_error("bad value for --resolution", text,
                    fmt::format("WIDTHxHEIGHT in pixels, such as 640x480, each from 1 to {}", largest_image_side));
}

// The command line as text, before it is taken apart.
struct Texts {
    std::string scene, legacy_scene, missing, plan, precision, progress;
    bool no_bake_cache = false;
    std::optional<std::string> bake_cache, frames, frame, time_limit, snapshot, resolution, spp, seed, max_depth,
        threads, exposure;
};

const char* const footer =
    "An option given several times counts as given last, but for -o.\n"
    "Ctrl-C and SIGTERM finish the tiles at hand and write the picture; a second one, and one before rendering has\n"
    "begun, ends the program at once.\n"
    "Exit codes: 0 done, 1 internal error, 2 wrong command line, 3 invalid scene, 4 input missing or unreadable,\n"
    "5 output not writable, 75 stopped by SIGTERM, 130 stopped by Ctrl-C";

void add_output_options(CLI::App& app, RenderArguments& a, Texts& t) {
    app.add_option("-o,--output", a.outputs,
                   "Picture to write: .exr .tif .hdr scene-linear, .png .jpg .bmp .tga .ppm .webp .gif .dpx through "
                   "the display transform; may be given several times. #### or %04d becomes the frame number. Always "
                   "a file: pictures replace their old version at once when complete, so - (the standard output) is "
                   "refused")
        ->option_text("FILE")
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
    app.add_option("-r,--resolution", t.resolution, "Picture size in pixels")->option_text("WIDTHxHEIGHT");
    app.add_option("--exposure", t.exposure, "Stops, for display pictures (all but .exr .tif .hdr)")
        ->option_text("STOPS");
    app.add_option("--snapshot", t.snapshot, "Write the picture so far, every SECONDS or after each pass")
        ->option_text("FILE[:SECONDS]");
}

void add_frame_options(CLI::App& app, RenderArguments& a, Texts& t) {
    app.add_option("-f,--frame", t.frame, "Frame to render (default 0)")->option_text("N");
    app.add_option("--frames", t.frames, "Frames to render: A-B, A-B:STEP, or a list such as 1-10,20")
        ->option_text("LIST");
    app.add_option("-c,--camera", a.plan.camera, "Camera to use (default: the one that records the frame)")
        ->option_text("NAME");
    app.add_flag("-p,--preview", a.preview, "Leave out all distributed effects");
}

void add_quality_options(CLI::App& app, Texts& t) {
    app.add_option("--spp", t.spp, "Samples per pixel")->option_text("N");
    app.add_option("--time-limit", t.time_limit,
                   "Stop a frame after this long: 90, 90s, 1.5m, 2h; one sample per "
                   "pixel is always taken")
        ->option_text("T");
    app.add_option("--seed", t.seed, "Seed of the sample points")->option_text("N");
    app.add_option("--max-depth", t.max_depth, "Reflections and refractions in a row")->option_text("N");
    app.add_option("--missing-textures", t.missing, "error (default) or checker: render on with a checker")
        ->check(CLI::IsMember({"error", "checker"}))
        ->option_text("error|checker");
}

void add_run_options(CLI::App& app, RenderArguments& a, Texts& t) {
    app.add_option("-t,--threads", t.threads, "Threads (0 = all)")->option_text("N");
    app.add_option("--plan", t.plan, "auto (default) or general: leave nothing out")
        ->check(CLI::IsMember({"auto", "general"}))
        ->option_text("auto|general");
    app.add_option("--precision", t.precision, "auto (default), single or double geometry")
        ->check(CLI::IsMember({"auto", "single", "double"}))
        ->option_text("auto|single|double");
    app.add_option("--bake-cache", t.bake_cache,
                   "Folder where motion computed from physics is kept (default: $XDG_CACHE_HOME/drt or ~/.cache/drt)")
        ->option_text("DIR");
    app.add_flag("--no-bake-cache", t.no_bake_cache, "Compute motion from physics anew and do not keep it");
    app.add_flag("--explain", a.explain,
                 "Print what the plan leaves out and why, to the standard output; computes motion from physics, even "
                 "with --check");
    app.add_flag("--check", a.check,
                 "Neither compute motion from physics nor render: read the scene and its textures, check the outputs");
    app.add_option("--progress", t.progress, "auto (default), bar, plain or none")
        ->check(CLI::IsMember({"auto", "bar", "plain", "none"}))
        ->option_text("auto|bar|plain|none");
    app.add_flag("-q,--quiet", a.quiet, "Print errors only, and what is wrong with a picture");
    app.add_flag("-v,--verbose", a.verbose, "Print notes and per-stage times");
    app.set_version_flag("--version", fmt::format("drt-render {} ({})", version(), build_isa()));
}

void add_options(CLI::App& app, RenderArguments& a, Texts& t) {
    // Not "scene", for --scene has that name: CLI11 2.4 refuses a positional that shares its name with an option.
    app.add_option("file", t.scene, "Scene file: YAML (.yaml, .yml) or legacy text")->option_text("FILE");
    app.add_option("-s,--scene", t.legacy_scene, "The same, as the 2008 program took it")->option_text("FILE");
    add_output_options(app, a, t);
    add_frame_options(app, a, t);
    add_quality_options(app, t);
    add_run_options(app, a, t);
    add_legacy_options(app, a.legacy);
    app.footer(footer);
}

void take_numbers(RenderArguments& a, const Texts& t) {
    Overrides& o = a.overrides;
    if (t.spp) o.spp = to_number(*t.spp, 1, largest_spp, "--spp");
    if (t.seed) o.seed = to_number<std::uint32_t>(*t.seed, 0, ~std::uint32_t(0), "--seed");
    if (t.max_depth) o.max_depth = to_number(*t.max_depth, 0, largest_depth, "--max-depth");
    if (t.threads) a.threads = to_number(*t.threads, 0, 1024, "--threads");
    if (t.exposure) a.display.exposure = to_number(*t.exposure, -100.0f, 100.0f, "--exposure");
    if (t.time_limit) a.time_limit = parse_time_limit(*t.time_limit);
    if (t.resolution) parse_resolution(*t.resolution, o);
}

void take_choices(RenderArguments& a, const Texts& t) {
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
}

void take_texts(RenderArguments& a, const Texts& t) {
    if (!t.scene.empty() && !t.legacy_scene.empty()) usage_error("two scene files", t.legacy_scene, "one");
    a.scene = t.scene.empty() ? t.legacy_scene : t.scene;
    if (a.scene.empty()) usage_error("no scene file", "", "drt-render scene.yaml -o out.exr");
    if (t.frame && t.frames) usage_error("both --frame and --frames", *t.frames, "one of them");
    if (t.frame) a.frames = {parse_frame(*t.frame)};
    if (t.frames) a.frames = parse_frames(*t.frames);
    if (t.snapshot) a.snapshot = parse_snapshot(*t.snapshot);
    if (t.bake_cache && t.bake_cache->empty()) usage_error("no folder after --bake-cache", "", "a folder");
    if (!t.no_bake_cache) a.bake_cache = t.bake_cache ? *t.bake_cache : default_bake_cache();
    take_numbers(a, t);
    take_choices(a, t);
    for (const std::string& path : a.outputs) {
        if (path.empty()) usage_error("no name after -o", "", "-o out.exr");
        if (path == "-") usage_error("pictures are written to files, not to", path, "-o out.exr");
    }
    if (a.outputs.empty() && !a.check && !a.explain)
        usage_error("no output file", "", "-o out.exr (or --check, --explain)");
}

}  // namespace

std::optional<RenderArguments> parse_arguments(int argc, char** argv) {
    CLI::App app{"Renders a scene to a picture by distributed ray tracing.", "drt-render"};
    let_last_option_win(app);
    RenderArguments a;
    Texts t;
    add_options(app, a, t);
    if (!parse_command_line(app, argc, argv)) return {};
    take_texts(a, t);
    return a;
}

}  // namespace drt
