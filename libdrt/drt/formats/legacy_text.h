#pragma once
// The bytes of a legacy file as UTF-8 text, or a located complaint.

#include <string>

#include "drt/formats/legacy_report.h"

namespace drt {

inline constexpr size_t largest_legacy_file = size_t(64) << 20;  ///< bytes

/// The whole file, from a regular file or a pipe. Throws Error: asset when it is missing or cannot be read, scene when
/// it is larger than largest_legacy_file.
std::string read_legacy_file(const std::string& path);

/// UTF-8 stays (a byte order mark too: the tokens skip it). Other text is taken for Windows-1250, the code page of the
/// program's time and country, and that is noted. Control characters and UTF-16 are errors: "" is returned then.
std::string legacy_text(std::string bytes, LegacyReport&);

}  // namespace drt
