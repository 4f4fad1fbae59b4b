#pragma once
// Defaults of missing attributes, and the account of those that were used.

#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "drt/formats/legacy_element.h"
#include "drt/formats/legacy_report.h"

namespace drt {

class LegacyDefaults {
public:
    /// Gives every attribute without a value its fallback; reports those that must be given.
    void fill(LegacyElement&, LegacyReport&);
    /// One note per kind and attribute that fill() had to give somewhere, with the names of some of the elements.
    void tell(LegacyReport&) const;

private:
    struct Use {
        LegacyPlace first;
        std::vector<std::string_view> names;
        size_t count = 0;
    };
    // Keyed by places in the tables, which gives the notes the tables' order.
    std::map<std::pair<const LegacyElementType*, const LegacyAttribute*>, Use> uses_;
};

}  // namespace drt
