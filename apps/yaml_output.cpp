#include "apps/yaml_output.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "apps/exit_codes.h"
#include "apps/standard_streams.h"
#include "drt/base/atomic_file.h"
#include "drt/base/version.h"

namespace drt {

namespace fs = std::filesystem;

void print(const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics) write_stderr(to_string(d) + '\n');
}

void check_not_input(const std::string& input, const std::string& output) {
    std::error_code ignored;
    if (output != "-" && fs::equivalent(input, output, ignored))
        throw Error(ErrorKind::usage, fmt::format("the output {} is the input; it is not overwritten", output));
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

}  // namespace

void write_yaml(const std::string& output, const std::string& text) {
    if (output == "-")
        write_stdout(text);
    else
        write_file(output, text);
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
