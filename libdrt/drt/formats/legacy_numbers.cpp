#include "drt/formats/legacy_numbers.h"

#include <cfloat>
#include <charconv>
#include <cmath>

namespace drt {

LegacyNumber parse_legacy_number(std::string_view word) {
    std::string_view digits = word;
    // from_chars knows no leading plus; strtod, which the 2008 program used, does.
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-' && digits[1] != '+') digits.remove_prefix(1);
    LegacyNumber n;
    const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), n.value);
    if (code == std::errc::result_out_of_range) return {0, "the number is out of the range of a double"};
    if (code != std::errc{} || end != digits.data() + digits.size()) {
        const bool decimal_comma =
            digits.find(',') != digits.npos && digits.find_first_not_of("+-0123456789,eE") == digits.npos;
        return {0, decimal_comma ? "a decimal comma; the format has a decimal point" : "not a number"};
    }
    if (!std::isfinite(n.value)) return {0, "not a finite number"};
    return n;
}

bool legacy_in_range(const LegacyAttribute& a, double value) {
    constexpr double largest_count = 1e6;
    if (a.type == LegacyType::flag) return value == 0 || value == 1;
    if (a.type == LegacyType::color) return std::fabs(value) <= double(FLT_MAX);
    if (a.type == LegacyType::whole && (value != std::floor(value) || value > largest_count)) return false;
    switch (a.range) {
        case LegacyRange::any:
            return true;
        case LegacyRange::positive:
            return value > 0;
        case LegacyRange::not_negative:
            return value >= 0;
        case LegacyRange::unit:
            return value >= 0 && value <= 1;
        case LegacyRange::not_zero:
            return value != 0;
    }
    return true;
}

}  // namespace drt
