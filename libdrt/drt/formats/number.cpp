#include "drt/formats/number.h"

#include <charconv>

namespace drt {
namespace {

template <class T>
NumberFault parse_prefix(const char*& begin, const char* end, T& value) {
    const char* p = begin;
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    if (p != end && *p == '+') ++p;  // from_chars knows no plus sign
    // from_chars also takes "inf" and "nan": insist on a digit in front
    const char* first = p;
    if (first != end && *first == '-' && p == begin) ++first;
    if (first != end && *first == '.') ++first;
    if (first == end || !is_digit(*first)) return NumberFault::not_a_number;
    T parsed{};
    const std::from_chars_result r = std::from_chars(p, end, parsed);
    if (r.ec == std::errc::invalid_argument) return NumberFault::not_a_number;
    begin = r.ptr;
    if (r.ec == std::errc::result_out_of_range) return NumberFault::out_of_range;
    value = parsed;
    return NumberFault::none;
}

template <class T>
NumberFault parse_all(std::string_view text, T& value) {
    const char* begin = text.data();
    const char* const end = begin + text.size();
    T parsed{};
    const NumberFault fault = parse_prefix(begin, end, parsed);
    if (begin != end) return NumberFault::not_a_number;
    if (fault == NumberFault::none) value = parsed;
    return fault;
}

}  // namespace

NumberFault parse_number(std::string_view text, double& value) { return parse_all(text, value); }
NumberFault parse_number(std::string_view text, float& value) { return parse_all(text, value); }
NumberFault parse_number(const char*& begin, const char* end, double& value) { return parse_prefix(begin, end, value); }

}  // namespace drt
