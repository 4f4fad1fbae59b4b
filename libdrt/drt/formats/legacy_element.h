#pragma once
// An element of a legacy scene as it was written, with defaults filled in.

#include <string_view>
#include <variant>
#include <vector>

#include "drt/base/vec.h"
#include "drt/formats/legacy_report.h"
#include "drt/formats/legacy_table.h"

namespace drt {

struct LegacyElement;

/// monostate: implicit (the fallback in words holds). A vector that repeats is a list.
using LegacyData =
    std::variant<std::monostate, double, Vec3d, std::string_view, std::vector<Vec3d>, std::vector<LegacyElement>>;

struct LegacyValue {
    LegacyData data;
    LegacyPlace place;         ///< of the value, or of the element when it was not given
    std::string_view spelled;  ///< the attribute as written (it may be an alias); empty when it was not given
    bool unread = false;       ///< it was given, or may have been, and could not be read: `data` is the default
};

struct LegacyElement {
    const LegacyElementType* type = nullptr;
    std::string_view name;
    LegacyPlace place, name_place;
    std::vector<LegacyValue> values;  ///< parallel to type->attributes

    // By the attribute's name in the table; asking for a name or a type that the table does not have is a bug.
    const LegacyValue& value(std::string_view attribute) const;
    bool given(std::string_view attribute) const { return !value(attribute).spelled.empty(); }
    bool implicit(std::string_view attribute) const;
    double real(std::string_view attribute) const;
    int whole(std::string_view attribute) const { return int(real(attribute)); }
    Vec3d vector(std::string_view attribute) const;
    std::string_view word(std::string_view attribute) const;  ///< "" when implicit
};

}  // namespace drt
