#include "drt/formats/legacy_defaults.h"

#include <string>

#include "drt/formats/legacy_numbers.h"
#include "drt/formats/legacy_tokens.h"

namespace drt {
namespace {

LegacyData fallback_data(const LegacyAttribute& a) {
    LegacyTokens words(a.fallback);
    std::vector<double> numbers;
    while (words.peek().kind == LegacyToken::Kind::word) {
        const LegacyNumber n = parse_legacy_number(words.next().text);
        if (!n.error.empty()) return {};
        numbers.push_back(n.value);
    }
    if (numbers.size() == 1) return numbers[0];
    if (numbers.size() != 3) return {};
    const Vec3d v{numbers[0], numbers[1], numbers[2]};
    if (a.repeats) return std::vector<Vec3d>{v};
    return v;
}

}  // namespace

void LegacyDefaults::fill(LegacyElement& e, LegacyReport& report) {
    for (size_t i = 0; i < e.values.size(); ++i) {
        const LegacyAttribute& a = e.type->attributes[i];
        LegacyValue& value = e.values[i];
        if (!std::holds_alternative<std::monostate>(value.data)) continue;
        value.data = fallback_data(a);
        if (!value.spelled.empty()) continue;  // it was given, and its error has been told
        if (value.place.line == 0) value.place = e.place;
        if (a.required)
            report.error(e.place, "the " + std::string(e.type->name) + " has no " + '"' + std::string(a.name) + '"',
                         e.name, legacy_expectation(a));
        if (a.fallback.empty()) continue;
        Use& use = uses_[{e.type, &a}];
        if (use.count++ == 0) use.first = e.place;
        if (use.names.size() < 4 && !e.name.empty()) use.names.push_back(e.name);
    }
}

void LegacyDefaults::tell(LegacyReport& report) const {
    for (const auto& [where, use] : uses_) {
        std::string message = "default used: " + std::string(where.first->name) + ' ' +
                              std::string(where.second->name) + " = " + std::string(where.second->fallback);
        for (size_t i = 0; i < use.names.size(); ++i)
            message += (i == 0 ? " (" : ", ") + std::string(use.names[i].substr(0, 64));
        if (use.names.size() < use.count && !use.names.empty())
            message += " and " + std::to_string(use.count - use.names.size()) + " more";
        if (!use.names.empty()) message += ')';
        report.note(use.first, message);
    }
}

}  // namespace drt
