#pragma once
// Text of a legacy scene -> its elements with checked values, and everything that is wrong with it. Knows the grammar
// and legacy_table.h, not what the elements mean.

#include <string_view>
#include <vector>

#include "drt/formats/legacy_element.h"
#include "drt/formats/legacy_report.h"

namespace drt {

/// The elements in the order of the file. What has errors is left out or carries its fallback; the text must outlive
/// the result. Time and memory are linear in the text.
std::vector<LegacyElement> parse_legacy(std::string_view text, LegacyReport&);

}  // namespace drt
