// drt-bake: a scene with physics -> the same scene with keyframes, in YAML. It renders the same without simulation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

#include "apps/command_line.h"
#include "apps/legacy_options.h"
#include "apps/standard_streams.h"
#include "apps/yaml_output.h"
#include "drt/bake/bake.h"
#include "drt/base/version.h"
#include "drt/formats/formats.h"
#include "drt/scene/scene_fields.h"

namespace drt {
namespace {

// Locale-free, and no nan.
std::string simulated_time(std::string& text) {
    double v{};
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), v);
    const bool read = code == std::errc{} && end == text.data() + text.size() && std::abs(v) <= latest_simulated;
    return read ? std::string()
                : fmt::format("expected a number of at most {:g} in size, not \"{}\"", latest_simulated, text);
}

struct Arguments {
    std::string input, output;
    std::optional<double> until;
    bool quiet = false;
    LegacyOptions legacy;
};

// How long the simulation goes on must come from somewhere.
double simulated_until(const SceneDesc& scene, const std::optional<double>& until) {
    if (until) return *until;
    const double shown = latest_shown(scene);
    if (!scene.simulation.end && shown <= scene.simulation.start)
        throw Error(ErrorKind::usage,
                    "how long is the simulation? No camera's video ends after its start, and the scene has no "
                    "simulation.end; give --until SECONDS");
    if (!scene.simulation.end && shown > latest_simulated)
        throw Error(ErrorKind::usage,
                    fmt::format("how long is the simulation? Cameras show it until t = {:g} s, too long to simulate; "
                                "give --until SECONDS, at most {:g}",
                                shown, latest_simulated));
    return shown;
}

// Where a body gets to may be nothing that a scene can say.
void check_readable(const SceneDesc& baked) {
    Diagnostics wrong = validate(baked);
    std::erase_if(wrong, [](const Diagnostic& d) { return d.severity != Severity::error; });
    if (wrong.empty()) return;
    wrong.push_back({Severity::note, {}, "this is of the motion as it was computed", {}, {}, {}});
    throw Error(ErrorKind::scene, std::move(wrong));
}

void bake_file(const Arguments& args) {
    const auto begin = std::chrono::steady_clock::now();
    check_output_name(args.input, args.output);
    const SceneRead read = read_scene(args.input, args.legacy);
    if (!args.quiet) print(read.notes);
    const double until = simulated_until(read.scene, args.until);
    check_output_place(read, args.output);
    const Baked baked = bake(read.scene, until);
    if (!args.quiet) print(baked.notes);
    check_readable(baked.scene);
    Diagnostics notes = read.notes;
    notes.insert(notes.end(), baked.notes.begin(), baked.notes.end());
    write_yaml(args.output, write_yaml_scene(baked.scene, folder_of_output(args.output),
                                             yaml_header("Baked", "drt-bake", args.input, notes)));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (!args.quiet) write_stderr(fmt::format("{}\nbaked in {:.3g} s\n", to_text(baked.report), seconds.count()));
}

void add_arguments(CLI::App& app, Arguments& args) {
    app.set_version_flag("--version", fmt::format("drt-bake {}", version()));
    app.add_option("scene", args.input, "YAML (.yaml, .yml) or legacy text")->required()->option_text("FILE");
    app.add_option("-o,--output", args.output, "YAML file to write, - for the standard output")
        ->required()
        ->option_text("FILE");
    app.add_option("--until", args.until, "scene time to simulate to, for videos without an end")
        ->check(CLI::Validator(simulated_time, ""))
        ->option_text("SECONDS");
    app.add_flag("-q,--quiet", args.quiet, "say nothing but errors");
    add_legacy_options(app, args.legacy);
    app.footer(
        "Exit codes: 0 done, 1 internal error, 2 wrong command line, 3 invalid scene, 4 input missing or unreadable,\n"
        "5 output not writable. A signal ends it at once, and nothing is written. What is computed and how exactly: "
        "docs/baking.md");
}

int run(int argc, char** argv) {
    CLI::App app("Turns a scene's physics into keyframes that render the same.", "drt-bake");
    let_last_option_win(app);
    Arguments args;
    add_arguments(app, args);
    return run_reporting_errors([&] {
        if (parse_command_line(app, argc, argv)) bake_file(args);
    });
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    drt::prepare_standard_streams();
    return drt::run(argc, argv);
}
