#pragma once
// Numbers of the legacy format: decimal, with a point, finite, independent of the locale.

#include <string_view>

#include "drt/formats/legacy_table.h"

namespace drt {

struct LegacyNumber {
    double value = 0;
    std::string_view error;  ///< empty: `value` holds
};

LegacyNumber parse_legacy_number(std::string_view word);

/// The attribute's range and limit, and what its type implies (a whole number, 0 or 1).
bool legacy_in_range(const LegacyAttribute&, double value);

}  // namespace drt
