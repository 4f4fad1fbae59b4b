#pragma once
// Is a text UTF-8? Names go into YAML files and messages; anything else would not read back.

#include <string_view>

namespace drt {

/// Offset of the first byte that is not part of well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates, nothing
/// above U+10FFFF), or npos.
std::size_t find_invalid_utf8(std::string_view);

}  // namespace drt
