#pragma once
// Names and references. Legacy names are unique per kind; SceneDesc's are unique per list (materials, bodies, lights),
// into which several kinds go.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drt/formats/legacy_element.h"

namespace drt {

class LegacyNames {
public:
    explicit LegacyNames(const std::vector<LegacyElement>&);

    /// The element's name in SceneDesc: its own, or for a kind that comes second to it in the same list name_kind
    /// ("ball_box"), with a number where that is taken too. Depends on the file only.
    const std::string& name(size_t element) const { return names_[element]; }

    /// A name that no element of the list has, from `wish`.
    std::string free_name(LegacyKind list_of, const std::string& wish) const;

    /// The element that reference attribute `attribute` of `elements[from]` means; empty when it is implicit, or not
    /// defined above (reported).
    std::optional<size_t> resolve(size_t from, std::string_view attribute, LegacyReport&) const;

private:
    const std::vector<LegacyElement>* elements_;
    std::vector<std::string> names_;
    std::map<std::pair<LegacyKind, std::string_view>, size_t> index_;
    std::map<std::pair<int, std::string>, bool> taken_;
};

}  // namespace drt
