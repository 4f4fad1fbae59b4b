#pragma once
// The legacy format as data: every element, every attribute with its type, range and default. The parser, the
// reader's notes and the tests all go by this table; docs/legacy-format.md states it for people.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "drt/scene/fields.h"

namespace drt {

enum class LegacyKind {
    settings,
    camera,
    phong_info,
    texture,
    material_phong,
    material_texture,
    plane,
    sphere,
    triangle,
    rectangle,
    box,
    light_point,
    light_rect,
    light_bulb,
    add_force_event,  // only inside a sphere, and without a name
};

enum class LegacyType {
    real,
    whole,   ///< a whole number, "32" or "32.0"
    flag,    ///< 0 or 1
    vector,  ///< { x y z }
    color,   ///< { r g b }, each within the range of a float
    word,
    reference,  ///< the name of an element that is defined above
    event,      ///< an add_force_event
};

enum class LegacyRange { any, positive, not_negative, unit, not_zero };

struct LegacyAttribute {
    std::string_view name;
    LegacyType type = LegacyType::real;
    /// What a missing attribute means: numbers in the file's own syntax, or words where the value is implicit.
    /// Empty: nothing is to be said (optional) or, with `required`, an error.
    std::string_view fallback = {};
    LegacyRange range = LegacyRange::any;
    double most = largest_number;  ///< in size
    bool minus_one = false;        ///< -1 stands for the fallback
    bool repeats = false;
    bool required = false;
    std::array<std::string_view, 2> aliases = {};
};

struct LegacyElementType {
    LegacyKind kind;
    std::string_view name;
    std::span<const LegacyAttribute> attributes;
};

/// All elements that may stand at the top of a file.
std::span<const LegacyElementType> legacy_elements();
/// nullptr when there is none of that name.
const LegacyElementType* find_legacy_element(std::string_view name);
const LegacyElementType& legacy_force_event();
/// Index of the attribute with that name or alias, -1 when there is none.
int find_legacy_attribute(const LegacyElementType&, std::string_view name);

/// "a number > 0", "{ x y z }": for messages.
std::string legacy_expectation(const LegacyAttribute&);
/// "a number of at most 1e15 in size": for messages about numbers beyond LegacyAttribute::most.
std::string legacy_size_expectation(const LegacyAttribute&);

}  // namespace drt
