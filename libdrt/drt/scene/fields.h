#pragma once
// What a table of fields (scene_fields.h) is made of: for each field of a struct its key, member, unit, range and
// meaning. validate(), the YAML reader and writer and the tables of docs/scene-format.md all walk the same tables, so
// that a field is described once. Defaults are not in the tables: they are those of the structs.

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "drt/base/vec.h"

namespace drt {

/// No number of a scene may be larger in size: squares and products of such lengths stay far inside float's exponents
/// where they are formed in double, and Embree (which stops at 1.8e18) never sees an infinite bound.
inline constexpr double largest_number = 1e15;

/// The legal interval of a number.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false, high_open = false;
    constexpr bool contains(double v) const {
        return (low_open ? v > low : v >= low) && (high_open ? v < high : v <= high);
    }
};

/// "> 0", ">= 0 and < 180"; "" when nothing is excluded.
std::string to_string(const Range&);

namespace ranges {
inline constexpr Range any{};
inline constexpr Range positive{.low = 0, .low_open = true};
inline constexpr Range not_negative{.low = 0};
inline constexpr Range unit{.low = 0, .high = 1};
}  // namespace ranges

/// What a field's value stands for, where its type does not say.
enum class Role {
    value,
    direction,  ///< a vector of any length but zero
    name,       ///< what others refer to this element by; unique among the elements of its list
    file,       ///< written relative to the file that holds it
    material,   ///< the name of a material
    texture,    ///< the name of a texture
};

enum class Presence {
    optional,        ///< has the struct's default when it is not written
    required,        ///< must be written
    first_required,  ///< must be written in the first item of a list; later items default to the previous item's
};

struct FieldInfo {
    std::string_view name;  ///< key in YAML and in SourceMap's paths
    std::string_view unit;
    Range range;
    std::string_view doc;
    Role role = Role::value;
    Presence presence = Presence::optional;
    std::string_view implicit{};  ///< what holds when an optional is not set
};

template <class T, class M>
struct Field {
    FieldInfo info;
    M T::*member;
};

/// A value that goes from start to end: one key, written as one value or as {start: , end: }.
template <class T, class Start, class End>
struct StartEnd {
    FieldInfo info;
    Start T::*start;  ///< V or std::optional<V>
    End T::*end;      ///< std::optional<V>
};

/// A list that mostly holds one value: `singular: v` or `info.name: [v, ...]`.
template <class T, class V>
struct OneOrMore {
    FieldInfo info;  ///< named by the plural
    std::string_view singular;
    std::vector<V> T::*member;
};

/// A variant whose alternatives' fields stand beside those of T; the key `info.name` says which alternative it is.
template <class T, class Variant>
struct Alternatives {
    FieldInfo info;
    Variant T::*member;
};

/// Specialised for every struct of SceneDesc:
///     static constexpr std::string_view name;      what the struct is called ("sphere"); the value of the key `type`
///     static constexpr std::string_view doc;       one line
///     static constexpr std::tuple table;           of Field, StartEnd, OneOrMore, Alternatives
template <class T>
struct Fields;

/// Specialised for every enum of SceneDesc: static constexpr std::array names, by value.
template <class E>
struct EnumNames;

template <class T>
concept HasFields = requires {
    Fields<T>::table;
};

template <class T>
concept IsEnum = std::is_enum_v<T>;

template <class E>
constexpr std::string_view enum_name(E value) requires IsEnum<E> {
    return EnumNames<E>::names[std::size_t(value)];
}

/// Calls f with each entry of T's table.
template <class T, class F>
constexpr void for_each_field(F&& f) {
    std::apply([&f](const auto&... entry) { (f(entry), ...); }, Fields<T>::table);
}

/// Calls f.template operator()<Alternative>() for each alternative of a variant.
template <class Variant, class F>
constexpr void for_each_alternative(F&& f) {
    [&f]<class... A>(std::type_identity<std::variant<A...>>) {
        (f.template operator()<A>(), ...);
    }(std::type_identity<Variant>{});
}

// ---- how the tables are written ----------------------------------------------------------------------------------

template <class T, class M>
constexpr Field<T, M> field(std::string_view name, M T::*member, std::string_view unit, Range range,
                            std::string_view doc, Role role = Role::value) {
    return {{name, unit, range, doc, role}, member};
}

template <class Entry>
constexpr Entry required(Entry e) {
    e.info.presence = Presence::required;
    return e;
}

template <class Entry>
constexpr Entry required_in_first(Entry e) {
    e.info.presence = Presence::first_required;
    return e;
}

template <class Entry>
constexpr Entry implicit(std::string_view what, Entry e) {
    e.info.implicit = what;
    return e;
}

template <class T, class Start, class End>
constexpr StartEnd<T, Start, End> start_end(std::string_view name, Start T::*start, End T::*end, std::string_view unit,
                                            Range range, std::string_view doc, Role role = Role::value) {
    return {{name, unit, range, doc, role}, start, end};
}

template <class T, class V>
constexpr OneOrMore<T, V> one_or_more(std::string_view singular, std::string_view plural, std::vector<V> T::*member,
                                      std::string_view unit, std::string_view doc) {
    return {{plural, unit, ranges::any, doc}, singular, member};
}

template <class T, class Variant>
constexpr Alternatives<T, Variant> alternatives(std::string_view name, Variant T::*member, std::string_view doc) {
    return {{name, "", ranges::any, doc, Role::value, Presence::required}, member};
}

}  // namespace drt
