#include "drt/formats/legacy_names.h"

#include <algorithm>
#include <span>

namespace drt {
namespace {

/// Number of the SceneDesc list that elements of a kind go to.
int list_of(LegacyKind kind) {
    switch (kind) {
        case LegacyKind::material_phong:
        case LegacyKind::material_texture:
            return 1;
        case LegacyKind::plane:
        case LegacyKind::sphere:
        case LegacyKind::triangle:
        case LegacyKind::rectangle:
        case LegacyKind::box:
            return 2;
        case LegacyKind::light_point:
        case LegacyKind::light_rect:
        case LegacyKind::light_bulb:
            return 3;
        default:
            return 10 + int(kind);  // a list of its own
    }
}

std::vector<LegacyKind> kinds_of_reference(std::string_view spelled) {
    if (spelled == "material") return {LegacyKind::material_phong, LegacyKind::material_texture};
    const LegacyElementType* type = find_legacy_element(spelled);
    return type ? std::vector{type->kind} : std::vector<LegacyKind>{};
}

}  // namespace

LegacyNames::LegacyNames(const std::vector<LegacyElement>& elements) : elements_(&elements), names_(elements.size()) {
    for (size_t i = 0; i < elements.size(); ++i) {
        const LegacyElement& e = elements[i];
        index_.try_emplace({e.type->kind, e.name}, i);
        // The first of a list keeps its name, wherever in the file the others stand.
        if (taken_.try_emplace({list_of(e.type->kind), std::string(e.name)}, true).second) names_[i] = e.name;
    }
    for (size_t i = 0; i < elements.size(); ++i) {
        const LegacyElement& e = elements[i];
        if (!names_[i].empty() || e.name.empty()) continue;
        names_[i] = free_name(e.type->kind, std::string(e.name) + '_' + std::string(e.type->name));
        taken_.try_emplace({list_of(e.type->kind), names_[i]}, true);
    }
}

std::string LegacyNames::free_name(LegacyKind kind, const std::string& wish) const {
    const int list = list_of(kind);
    if (!taken_.contains({list, wish})) return wish;
    int n = 2;
    while (taken_.contains({list, wish + '_' + std::to_string(n)})) ++n;
    return wish + '_' + std::to_string(n);
}

std::optional<size_t> LegacyNames::resolve(size_t from, std::string_view attribute, LegacyReport& report) const {
    const LegacyElement& e = (*elements_)[from];
    const LegacyValue& value = e.value(attribute);
    const std::string_view wanted = e.word(attribute);
    if (wanted.empty()) return {};
    const std::vector<LegacyKind> kinds = kinds_of_reference(value.spelled);
    std::optional<size_t> found, below;
    bool ambiguous = false;
    for (const LegacyKind kind : kinds) {
        const auto it = index_.find({kind, wanted});
        if (it == index_.end()) continue;
        if (it->second > from) {
            below = it->second;
            continue;
        }
        ambiguous = found.has_value();
        found = std::max(found.value_or(0), it->second);
    }
    if (ambiguous)
        report.warning(value.place,
                       "both a material_phong and a material_texture have this name; the later one is taken", wanted,
                       "material_phong or material_texture before the name");
    if (found) return found;
    if (below) {
        report.error(value.place,
                     std::string(value.spelled) + " is defined only further down, at line " +
                         std::to_string((*elements_)[*below].place.line),
                     wanted, "an element defined above");
        return {};
    }
    std::vector<std::string_view> near;
    for (const auto& [key, index] : index_)
        if (index < from && std::ranges::find(kinds, key.first) != kinds.end() && near.size() < 1000)
            near.push_back(key.second);
    report.error(value.place, "undefined " + std::string(value.spelled), wanted, "the name of an element defined above",
                 nearest_word(wanted, near));
    return {};
}

}  // namespace drt
