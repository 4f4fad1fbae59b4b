#pragma once
// What programs that turn a scene into a YAML scene have in common.

#include <functional>
#include <string>

#include "drt/formats/formats.h"

namespace drt {

/// To the standard error, a line each.
void print(const Diagnostics&);

/// Throws Error (usage) if the output has no name or would overwrite the input.
void check_output_name(const std::string& input, const std::string& output);

/// What is known of the output before there is anything to write. Throws Error (usage) if it would overwrite a file of
/// the scene, and Error (output) if it cannot be written: no such folder, no permission, a folder itself.
void check_output_place(const SceneRead&, const std::string& output);

/// The folder that files of the scene are to be named relative to; that of the process for the standard output.
std::string folder_of_output(const std::string& output);

/// "<what> by <program> <version> from <input>", and the notes without the path, which may mean nothing where the file
/// ends up.
std::string yaml_header(const std::string& what, const std::string& program, const std::string& input,
                        const Diagnostics& notes);

/// Replaces a file as a whole; writes to devices and pipes, and for "-" to the standard output. Throws Error (output).
void write_yaml(const std::string& output, const std::string& text);

/// Runs a program's `work` between the standard streams and the exit codes: every error is printed.
int run_reporting_errors(const std::function<void()>& work);

}  // namespace drt
