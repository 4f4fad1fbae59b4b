#pragma once
// Decimal numbers in text, the same in every locale. Internal to the formats room.

#include <string_view>

namespace drt {

enum class NumberFault { none, not_a_number, out_of_range };

/// The whole of `text` as a decimal number: sign, digits, point, exponent; no blanks, hex, inf or nan.
/// `value` is only set when there is no fault.
NumberFault parse_number(std::string_view text, double& value);
NumberFault parse_number(std::string_view text, float& value);

/// The same at the start of [begin, end); moves begin behind the number.
NumberFault parse_number(const char*& begin, const char* end, double& value);

}  // namespace drt
