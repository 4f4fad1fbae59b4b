#include "apps/yaml_output.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>
#include <span>

#include "apps/exit_codes.h"
#include "apps/input_files.h"
#include "apps/standard_streams.h"
#include "drt/base/atomic_file.h"
#include "drt/base/version.h"

namespace drt {

namespace fs = std::filesystem;

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics) write_stderr(to_string(d) + '\n');
}

namespace {

template <class Work>
void reporting(const std::string& path, const Work& work) {
    try {
        work();
    } catch (const std::exception& e) {
        throw Error(ErrorKind::output, fmt::format("cannot write {}: {}", path, e.what()));
    }
}

// A device or a pipe is written to, not replaced.
bool is_replaced(const std::string& path) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    return !fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status);
}

}  // namespace

void check_output_name(const std::string& input, const std::string& output) {
    if (output.empty()) throw Error(ErrorKind::usage, "the output has no name; expected a file, or -");
    std::error_code ignored;
    if (output != "-" && fs::equivalent(input, output, ignored))
        throw Error(ErrorKind::usage, fmt::format("the output {} is the input; it is not overwritten", output));
}

void check_output_place(const SceneRead& read, const std::string& output) {
    if (output == "-" || !is_replaced(output)) return;
    check_inputs_kept({FileNames()(output)}, read);
    reporting(output, [&] {
        check_replaceable(output);
        remove_stale_temporaries(output);
    });
}

std::string folder_of_output(const std::string& output) {
    return (output == "-" ? fs::current_path() : fs::absolute(output).parent_path()).string();
}

std::string yaml_header(const std::string& what, const std::string& program, const std::string& input,
                        const Diagnostics& notes) {
    std::string out = fmt::format("{} by {} {} from {}", what, program, version(), fs::path(input).filename().string());
    for (Diagnostic d : notes) {
        d.where.file = d.where.line > 0 ? "line" : "";
        out += '\n' + to_string(d);
    }
    return out;
}

namespace {

void write_file(const std::string& path, const std::string& text) {
    const std::span bytes(reinterpret_cast<const unsigned char*>(text.data()), text.size());
    if (!is_replaced(path)) return write_bytes(path, bytes);
    replace_file(
        path, [&](const std::string& temporary) { write_bytes(temporary, bytes); },
        [&](const std::string& temporary) {
            if (fs::file_size(temporary) != text.size()) throw std::runtime_error("the file was cut short");
        });
}

}  // namespace

void write_yaml(const std::string& output, const std::string& text) {
    if (output == "-")
        write_stdout(text);
    else
        reporting(output, [&] { write_file(output, text); });
}

int run_reporting_errors(const std::function<void()>& work) {
    try {
        work();
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

}  // namespace drt
