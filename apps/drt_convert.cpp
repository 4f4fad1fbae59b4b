// drt-convert: a scene of either format -> the same scene in YAML.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "apps/command_line.h"
#include "apps/legacy_options.h"
#include "apps/standard_streams.h"
#include "apps/yaml_output.h"
#include "drt/base/version.h"
#include "drt/formats/formats.h"

namespace drt {
namespace {

struct Arguments {
    std::string input, output;
    bool quiet = false;
    LegacyOptions legacy;
};

/// Files that the scene names and that are not there. Rendering needs them, converting does not.
void warn_missing_textures(SceneRead& read) {
    for (size_t i = 0; i < read.scene.textures.size(); ++i) {
        const Texture& t = read.scene.textures[i];
        std::error_code ignored;
        if (std::filesystem::exists(t.file, ignored)) continue;
        Diagnostic d;
        d.severity = Severity::warning;
        d.where = read.scene.sources.find(fmt::format("textures[{}].file", i));
        d.message = "the texture file does not exist:";
        d.text = t.file;
        read.notes.push_back(std::move(d));
    }
}

void convert(const Arguments& args) {
    check_output_name(args.input, args.output);
    SceneRead read = read_scene(args.input, args.legacy);
    check_output_place(read, args.output);
    warn_missing_textures(read);
    if (!args.quiet) print(read.notes);
    write_yaml(args.output, write_yaml_scene(read.scene, folder_of_output(args.output),
                                             yaml_header("Converted", "drt-convert", args.input, read.notes)));
}

void add_arguments(CLI::App& app, Arguments& args) {
    app.set_version_flag("--version", fmt::format("drt-convert {}", version()));
    app.add_option("scene", args.input, "legacy text, or YAML (.yaml, .yml) to be normalised")
        ->required()
        ->option_text("FILE");
    app.add_option("-o,--output", args.output, "YAML file to write, - for the standard output")
        ->required()
        ->option_text("FILE");
    app.add_flag("-q,--quiet", args.quiet, "say nothing but errors");
    add_legacy_options(app, args.legacy);
    app.footer(
        "Exit codes: 0 done, 1 internal error, 2 wrong command line, 3 invalid scene, 4 input missing or unreadable,\n"
        "5 output not writable. What the conversion assumes: docs/legacy-format.md");
}

int run(int argc, char** argv) {
    CLI::App app("Converts a scene to YAML, and says what it assumed.", "drt-convert");
    let_last_option_win(app);
    Arguments args;
    add_arguments(app, args);
    return run_reporting_errors([&] {
        if (parse_command_line(app, argc, argv)) convert(args);
    });
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    drt::prepare_standard_streams();
    return drt::run(argc, argv);
}
