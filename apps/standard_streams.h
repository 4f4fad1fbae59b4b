#pragma once
// The three streams that every program is given, or not given.

#include <string_view>

namespace drt {

/// To be called before any file is opened. A standard stream that is closed is replaced by one that can be neither
/// read nor written: otherwise the next file to be opened, perhaps the picture, would take its number and get what is
/// printed. Writing to a broken pipe or past a file-size limit becomes an ordinary error instead of a signal.
void prepare_standard_streams();

/// Writes and flushes. Throws Error (output) when the text cannot be written: a full disk, a closed stream.
void write_stdout(std::string_view text);

/// Writes and flushes. A message that nobody can receive is no reason to fail, so this never does.
void write_stderr(std::string_view text) noexcept;

}  // namespace drt
