#include "drt/formats/legacy_table.h"

#include <algorithm>

#include "drt/scene/scene_fields.h"
#include "drt/scene/value_text.h"

namespace drt {
namespace {

using Type = LegacyType;
using Range = LegacyRange;

constexpr LegacyAttribute number(std::string_view name, std::string_view fallback, Range range = Range::any) {
    return {.name = name, .type = Type::real, .fallback = fallback, .range = range};
}
constexpr LegacyAttribute vector(std::string_view name, std::string_view fallback) {
    return {.name = name, .type = Type::vector, .fallback = fallback};
}
constexpr LegacyAttribute color(std::string_view name, std::string_view fallback) {
    return {.name = name, .type = Type::color, .fallback = fallback};
}
constexpr LegacyAttribute flag(std::string_view name) { return {.name = name, .type = Type::flag, .fallback = "0"}; }
// -1 in settings and cameras means "use the implicit value" (thesis, appendix 1, "Nastavení kamery").
constexpr LegacyAttribute or_implicit(LegacyAttribute a) {
    a.minus_one = true;
    return a;
}
constexpr LegacyAttribute count(std::string_view name, std::string_view fallback, double most = 1e6,
                                Range range = Range::not_negative) {
    return or_implicit({.name = name, .type = Type::whole, .fallback = fallback, .range = range, .most = most});
}
/// Radians, in a scene degrees.
constexpr LegacyAttribute spread(std::string_view name) {
    LegacyAttribute a = number(name, "0", Range::not_negative);
    a.most = 1e13;
    return a;
}
constexpr LegacyAttribute repeated(LegacyAttribute a) {
    a.repeats = true;
    return a;
}
constexpr LegacyAttribute also(LegacyAttribute a, std::string_view alias) {
    a.aliases[0] = alias;
    return a;
}
constexpr LegacyAttribute phong_info{
    .name = "phong_info", .type = Type::reference, .fallback = "the defaults of phong_info"};
constexpr LegacyAttribute material{.name = "material",
                                   .type = Type::reference,
                                   .fallback = "a plain grey material",
                                   .aliases = {"material_phong", "material_texture"}};

// The thesis gives no defaults. These switch an effect on only where the file asks for its strength (dof_c, a light's
// size, diffuse_reflection) or, for the shutter, its samples; the depth is the manual's advice ("2-4").
constexpr LegacyAttribute settings[] = {
    count("width", "640", largest_image_side, Range::positive),
    count("height", "480", largest_image_side, Range::positive),
    or_implicit(number("fps", "25", Range::positive)),
    count("interpolate_samples", "0"),
    count("blur_samples", "0"),
    or_implicit(number("blur_duration", "one frame", Range::not_negative)),
    or_implicit(number("blur_switch_ratio", "0", Range::unit)),
    count("dof_samples", "1"),
    or_implicit(number("dof_c", "0", Range::not_negative)),
    count("soft_shadow_samples", "1"),
    count("diffuse_reflection_samples", "1"),
    count("diffuse_refraction_samples", "1"),
    count("recursion", "3", largest_depth),
};

constexpr LegacyAttribute camera[] = {
    or_implicit(number("video_start", "the end of the camera above, or 0", Range::not_negative)),
    or_implicit(number("video_end", "as long as the scene time it shows, or until the next camera, or for ever")),
    or_implicit(number("time_start", "video_start")),
    or_implicit(number("time_end", "time_start + the length of the video")),
    or_implicit(number("DOF_start", "the distance to the target", Range::positive)),
    or_implicit(number("DOF_end", "as DOF_start", Range::positive)),
    or_implicit(number("FOV_start", "an angle of 45 degrees", Range::positive)),
    or_implicit(number("FOV_end", "as FOV_start", Range::positive)),
    repeated(vector("add_position", "0 0 5")),
    repeated(vector("add_target", "0 0 0")),
    vector("sky_start", "0 1 0"),
    vector("sky_end", "as sky_start"),
};

constexpr LegacyAttribute phong[] = {
    color("ambient", "1 1 1"),
    color("diffuse", "0.5 0.5 0.5"),
    color("specular", "0 0 0"),
    number("shininess", "20", Range::not_negative),
    number("reflectance", "0", Range::not_negative),
    spread("diffuse_reflection"),
    number("refraction", "0", Range::not_negative),
    spread("diffuse_refraction"),
    number("refraction_index", "1.5", Range::positive),
};

constexpr LegacyAttribute texture[] = {
    {.name = "file", .type = Type::word, .required = true, .aliases = {"filename"}},
};

constexpr LegacyAttribute material_phong[] = {phong_info};

constexpr LegacyAttribute material_texture[] = {
    phong_info,
    {.name = "texture", .type = Type::reference, .fallback = "none"},
    number("scale_U", "1", Range::positive),
    number("scale_V", "1", Range::positive),
};

constexpr LegacyAttribute plane[] = {vector("normal", "0 1 0"), vector("position", "0 0 0"), material};

constexpr LegacyAttribute sphere[] = {
    vector("position", "0 0 0"),
    number("radius", "1", Range::positive),
    material,
    {.name = "add_force_event", .type = Type::event, .repeats = true},
    flag("use_physics"),
    vector("v_e", "0 1 0"),
    vector("v_n", "0 0 1"),
};

constexpr LegacyAttribute triangle[] = {vector("vertex0", "0 0 0"), vector("vertex1", "1 0 0"),
                                        vector("vertex2", "0 1 0"), material};

// The manual's list calls vertex1 "position1".
constexpr LegacyAttribute rectangle[] = {vector("vertex0", "0 0 0"), also(vector("vertex1", "1 0 0"), "position1"),
                                         vector("vertex2", "0 1 0"), material};

constexpr LegacyAttribute box[] = {vector("vertex0", "0 0 0"), vector("vertex1", "1 0 0"),
                                   vector("vertex2", "0 0 1"), number("height", "1", Range::not_zero),
                                   flag("use_physics"),        material};

constexpr LegacyAttribute light_point[] = {vector("position", "0 0 0"), color("color", "1 1 1")};
constexpr LegacyAttribute light_rect[] = {vector("position", "0 0 0"), vector("x", "1 0 0"), vector("y", "0 0 1"),
                                          color("color", "1 1 1")};
constexpr LegacyAttribute light_bulb[] = {vector("position", "0 0 0"), number("radius", "1", Range::positive),
                                          color("color", "1 1 1")};

constexpr LegacyAttribute force_event[] = {vector("force", "0 0 0"), number("time", "0", Range::not_negative)};

constexpr LegacyElementType elements[] = {
    {LegacyKind::settings, "settings", settings},
    {LegacyKind::camera, "camera", camera},
    {LegacyKind::phong_info, "phong_info", phong},
    {LegacyKind::texture, "texture", texture},
    {LegacyKind::material_phong, "material_phong", material_phong},
    {LegacyKind::material_texture, "material_texture", material_texture},
    {LegacyKind::plane, "plane", plane},
    {LegacyKind::sphere, "sphere", sphere},
    {LegacyKind::triangle, "triangle", triangle},
    {LegacyKind::rectangle, "rectangle", rectangle},
    {LegacyKind::box, "box", box},
    {LegacyKind::light_point, "light_point", light_point},
    {LegacyKind::light_rect, "light_rect", light_rect},
    {LegacyKind::light_bulb, "light_bulb", light_bulb},
};

constexpr LegacyElementType event{LegacyKind::add_force_event, "add_force_event", force_event};

std::string_view number_expectation(Range range) {
    switch (range) {
        case Range::any:
            return "a number";
        case Range::positive:
            return "a number > 0";
        case Range::not_negative:
            return "a number >= 0";
        case Range::unit:
            return "a number from 0 to 1";
        case Range::not_zero:
            return "a number other than 0";
    }
    return "a number";
}

}  // namespace

std::span<const LegacyElementType> legacy_elements() { return elements; }

const LegacyElementType* find_legacy_element(std::string_view name) {
    const auto it = std::ranges::find(elements, name, &LegacyElementType::name);
    return it == std::end(elements) ? nullptr : &*it;
}

const LegacyElementType& legacy_force_event() { return event; }

int find_legacy_attribute(const LegacyElementType& element, std::string_view name) {
    const auto is_named = [name](const LegacyAttribute& a) {
        return a.name == name || (!name.empty() && std::ranges::find(a.aliases, name) != a.aliases.end());
    };
    const auto it = std::ranges::find_if(element.attributes, is_named);
    return it == element.attributes.end() ? -1 : int(it - element.attributes.begin());
}

std::string legacy_size_expectation(const LegacyAttribute& a) {
    return "a number of at most " + to_text(a.most) + " in size";
}

std::string legacy_expectation(const LegacyAttribute& a) {
    switch (a.type) {
        case Type::real:
            return std::string(number_expectation(a.range));
        case Type::whole:
            return "a whole number from " + std::string(a.range == LegacyRange::positive ? "1" : "0") + " to " +
                   std::to_string(int(a.most));
        case Type::flag:
            return "0 or 1";
        case Type::vector:
            return "{ x y z }";
        case Type::color:
            return "{ r g b }";
        case Type::word:
            return "a file name";
        case Type::reference:
            return "the name of an element defined above";
        case Type::event:
            return "{ force { x y z } time t }";
    }
    return {};
}

}  // namespace drt
