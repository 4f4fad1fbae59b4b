#pragma once
// Input files as text. Internal to the formats room.

#include <cstddef>
#include <string>
#include <string_view>

#include "drt/base/diagnostic.h"

namespace drt {

struct FileText {
    std::string text;
    std::string problem;  ///< why there is no text ("No such file or directory"); empty when there is
    bool too_large = false;
};

/// Reads a whole file (or pipe) of at most max_bytes.
FileText read_file(const std::string& path, std::size_t max_bytes);

/// 1-based line and column of a byte; columns count characters, not bytes.
Location location_in(const std::string& file, std::string_view text, std::size_t offset);

/// What follows `offset` on its line, cut to a length that fits into a message.
std::string snippet(std::string_view text, std::size_t offset);

/// The word that begins at `offset`.
std::string word_at(std::string_view text, std::size_t offset);

/// `text` fit for one line of a message: control characters as \xNN, cut to 60 bytes.
std::string printable(std::string_view text);

}  // namespace drt
