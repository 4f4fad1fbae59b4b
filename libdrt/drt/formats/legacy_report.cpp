#include "drt/formats/legacy_report.h"

namespace drt {
namespace {

/// At most 60 bytes of `text`, cut at a character.
std::string shortened(std::string_view text) {
    if (text.size() <= 60) return std::string(text);
    size_t n = 57;
    while (n > 0 && (static_cast<unsigned char>(text[n]) & 0xC0) == 0x80) --n;
    return std::string(text.substr(0, n)) + "...";
}

}  // namespace

void LegacyReport::add(Severity severity, LegacyPlace p, std::string&& message, std::string_view text,
                       std::string_view expected, std::string&& suggestion) {
    diagnostics_.push_back(
        {severity, location(p), std::move(message), shortened(text), std::string(expected), std::move(suggestion)});
}

void LegacyReport::error(LegacyPlace p, std::string message, std::string_view text, std::string_view expected,
                         std::string suggestion) {
    if (++errors_ <= max_errors)
        return add(Severity::error, p, std::move(message), text, expected, std::move(suggestion));
    if (errors_ == max_errors + 1)
        add(Severity::error, p, "more errors follow; the first " + std::to_string(max_errors) + " are shown", {}, {},
            {});
}

void LegacyReport::warning(LegacyPlace p, std::string message, std::string_view text, std::string_view expected) {
    add(Severity::warning, p, std::move(message), text, expected, {});
}

void LegacyReport::note(LegacyPlace p, std::string message) { add(Severity::note, p, std::move(message), {}, {}, {}); }

}  // namespace drt
