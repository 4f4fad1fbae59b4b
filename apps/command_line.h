#pragma once
// What the command lines of all programs have in common.

#include <CLI/CLI.hpp>

namespace drt {

/// To be called before options are added. Of an option that is given several times the last one counts, so that a
/// script's options can be overridden by appending; options that collect say so themselves.
void let_last_option_win(CLI::App&);

/// False when all is said and done: --help or --version has been printed. Throws Error (usage) for a wrong command
/// line, and Error (output) when the text cannot be printed.
bool parse_command_line(CLI::App&, int argc, char** argv);

}  // namespace drt
