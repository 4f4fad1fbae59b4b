#pragma once
// Faults of YAML text that must be found before a YAML parser sees it. Internal to the formats room.

#include <string>
#include <string_view>

#include "drt/base/diagnostic.h"

namespace drt {

/// The text without a byte order mark.
std::string_view without_bom(std::string_view text);

/// Text that is not UTF-8, control characters, tabs used for indentation, brackets nested without end.
Diagnostics check_yaml_text(const std::string& file, std::string_view text);

}  // namespace drt
