#include "drt/formats/legacy_numbers.h"

#include <cmath>

#include "drt/formats/number.h"

namespace drt {

LegacyNumber parse_legacy_number(std::string_view word) {
    LegacyNumber n;
    const NumberFault fault = parse_number(word, n.value);
    if (fault == NumberFault::none) return n;
    if (fault == NumberFault::out_of_range)
        n.error = "the number is out of the range of a double";
    else if (word.find(',') != word.npos && word.find_first_not_of("+-0123456789,eE") == word.npos)
        n.error = "a decimal comma; the format has a decimal point";
    else
        n.error = "not a number";
    return n;
}

bool legacy_in_range(const LegacyAttribute& a, double value) {
    if (a.type == LegacyType::flag) return value == 0 || value == 1;
    if (std::fabs(value) > a.most) return false;
    if (a.type == LegacyType::whole && value != std::floor(value)) return false;
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
