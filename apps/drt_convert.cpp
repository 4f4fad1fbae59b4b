// drt-convert: a scene of either format -> the same scene in YAML.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <new>
#include <span>
#include <string>

#include "apps/command_line.h"
#include "apps/exit_codes.h"
#include "apps/legacy_options.h"
#include "apps/standard_streams.h"
#include "drt/base/atomic_file.h"
#include "drt/base/version.h"
#include "drt/formats/formats.h"

namespace drt {
namespace {

namespace fs = std::filesystem;

struct Arguments {
    std::string input, output;
    bool quiet = false;
    LegacyOptions legacy;
};

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics) write_stderr(to_string(d) + '\n');
}

/// Files that the scene names and that are not there. Rendering needs them, converting does not.
void warn_missing_textures(SceneRead& read) {
    for (size_t i = 0; i < read.scene.textures.size(); ++i) {
        const Texture& t = read.scene.textures[i];
        std::error_code ignored;
        if (fs::exists(t.file, ignored)) continue;
        Diagnostic d;
        d.severity = Severity::warning;
        d.where = read.scene.sources.find(fmt::format("textures[{}].file", i));
        d.message = "the texture file does not exist:";
        d.text = t.file;
        read.notes.push_back(std::move(d));
    }
}

/// The notes as they go to the top of the YAML file: without the path, which may mean nothing where the file ends up.
std::string header(const Arguments& args, const SceneRead& read) {
    std::string out =
        fmt::format("Converted by drt-convert {} from {}", version(), fs::path(args.input).filename().string());
    for (Diagnostic d : read.notes) {
        d.where.file = d.where.line > 0 ? "line" : "";
        out += '\n' + to_string(d);
    }
    return out;
}

void write_file(const std::string& path, const std::string& text) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
    try {
        std::error_code ignored;
        const fs::file_status status = fs::status(path, ignored);
        // A device or a pipe is written to, not replaced.
        if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
            return write_bytes(path, {bytes, text.size()});
        check_replaceable(path);
        replace_file(
            path,
            [&](const std::string& temporary) {
                write_bytes(temporary, {bytes, text.size()});
            },
            [&](const std::string& temporary) {
                if (fs::file_size(temporary) != text.size()) throw std::runtime_error("the file was cut short");
            });
    } catch (const std::exception& e) {
        throw Error(ErrorKind::output, fmt::format("cannot write {}: {}", path, e.what()));
    }
}

void check_not_input(const Arguments& args) {
    std::error_code ignored;
    if (fs::equivalent(args.input, args.output, ignored))
        throw Error(ErrorKind::usage, fmt::format("the output {} is the input; it is not overwritten", args.output));
}

void convert(const Arguments& args) {
    const bool to_stdout = args.output == "-";
    if (!to_stdout) check_not_input(args);
    SceneRead read = read_scene(args.input, args.legacy);
    warn_missing_textures(read);
    if (!args.quiet) print(read.notes);
    const fs::path folder = to_stdout ? fs::current_path() : fs::absolute(args.output).parent_path();
    const std::string text = write_yaml_scene(read.scene, folder.string(), header(args, read));
    if (to_stdout)
        write_stdout(text);
    else
        write_file(args.output, text);
}

void add_arguments(CLI::App& app, Arguments& args) {
    app.set_version_flag("--version", fmt::format("drt-convert {}", version()));
    app.add_option("scene", args.input, "legacy text, or YAML (.yaml, .yml) to be normalised")->required();
    app.add_option("-o,--output", args.output, "YAML file to write, - for the standard output")->required();
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
    try {
        if (parse_command_line(app, argc, argv)) convert(args);
        return exit_ok;
    } catch (const Error& e) {
        print(e.diagnostics());
        return exit_code(e.kind());
    } catch (const std::bad_alloc&) {
        write_stderr("error: out of memory\n");
    } catch (const std::exception& e) {
        write_stderr(fmt::format("error: internal: {}\n", e.what()));
    }
    return exit_internal;
}

}  // namespace
}  // namespace drt

int main(int argc, char** argv) {
    drt::prepare_standard_streams();
    return drt::run(argc, argv);
}
