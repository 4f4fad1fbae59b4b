#include "drt/formats/legacy_report.h"

#include "drt/formats/text_file.h"

namespace drt {

void LegacyReport::add(Severity severity, LegacyPlace p, std::string&& message, std::string_view text,
                       std::string_view expected, std::string&& suggestion) {
    diagnostics_.push_back(
        {severity, location(p), std::move(message), printable(text), std::string(expected), std::move(suggestion)});
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
