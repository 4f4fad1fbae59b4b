#include "formats/scene_reference.h"

#include <algorithm>

#include "drt/scene/scene_fields.h"
#include "drt/scene/value_text.h"

namespace drt {
namespace {

std::string code(std::string_view text) { return '`' + std::string(text) + '`'; }

template <class V>
struct IsOptional : std::false_type {};
template <class V>
struct IsOptional<std::optional<V>> : std::true_type {};
template <class V>
struct IsList : std::false_type {};
template <class V>
struct IsList<std::vector<V>> : std::true_type {};

// ---- types ---------------------------------------------------------------------------------------------------------

template <class V>
std::string type_text(const FieldInfo& info) {
    if constexpr (IsOptional<V>::value) {
        return type_text<typename V::value_type>(info);
    } else if constexpr (IsList<V>::value) {
        return "list of " + type_text<typename V::value_type>(info);
    } else if constexpr (HasFields<V>) {
        return std::string(Fields<V>::name);
    } else if constexpr (IsEnum<V>) {
        std::string out;
        for (const std::string_view name : EnumNames<V>::names) out += (out.empty() ? "" : ", ") + code(name);
        return out;
    } else if constexpr (std::is_same_v<V, std::string>) {
        return info.role == Role::file       ? "file"
               : info.role == Role::material ? "name of a material"
               : info.role == Role::texture  ? "name of a texture"
                                             : "text";
    } else if constexpr (std::is_same_v<V, bool>) {
        return "`true`, `false`";
    } else if constexpr (std::is_same_v<V, Vec3d>) {
        return "vector";
    } else if constexpr (std::is_same_v<V, Color>) {
        return "colour";
    } else if constexpr (std::is_same_v<V, Quatd>) {
        return "orientation";
    } else {
        return std::is_integral_v<V> ? "integer" : "number";
    }
}

// ---- defaults ------------------------------------------------------------------------------------------------------

template <class V>
std::string default_text(const FieldInfo& info, const V& value) {
    if (info.presence == Presence::required) return "required";
    if (info.presence == Presence::first_required) return "the previous one's; required in the first";
    if (IsOptional<V>::value || !info.implicit.empty()) return std::string(info.implicit);
    if constexpr (IsOptional<V>::value)
        return {};
    else if constexpr (HasFields<V>)
        return "as its keys";
    else if constexpr (IsList<V>::value)
        return "none";
    else if constexpr (IsEnum<V>)
        return code(enum_name(value));
    else if constexpr (std::is_same_v<V, std::string>)
        return value.empty() ? "none" : code(value);
    else
        return code(to_text(value));
}

// ---- rows ----------------------------------------------------------------------------------------------------------

std::string row(const FieldInfo& info, std::string_view key, const std::string& type, const std::string& value) {
    std::string limits = to_string(info.range);
    if (info.role == Role::direction) limits = "not zero";
    std::string out = "|";
    for (const std::string& cell : {code(key), type, std::string(info.unit), value, limits, std::string(info.doc)})
        out += (cell.empty() ? "" : ' ' + cell) + " |";
    return out + '\n';
}

template <class T, class M>
std::string rows(const Field<T, M>& f) {
    return row(f.info, f.info.name, type_text<M>(f.info), default_text(f.info, T{}.*f.member));
}

template <class T, class Start, class End>
std::string rows(const StartEnd<T, Start, End>& f) {
    const std::string type = type_text<Start>(f.info);
    const std::string pair = "{start: " + type + ", end: " + type + "}";
    if constexpr (IsOptional<Start>::value)
        return row(f.info, f.info.name, type + " or " + pair, std::string(f.info.implicit));
    else
        return row(f.info, f.info.name, type + " or " + pair, default_text(f.info, T{}.*f.start));
}

template <class T, class V>
std::string rows(const OneOrMore<T, V>& f) {
    const std::string type = type_text<V>(f.info);
    const std::string one = default_text(f.info, (T{}.*f.member).front());
    FieldInfo several = f.info;
    several.doc = "several, in place of the key above";
    return row(f.info, f.singular, type, one) + row(several, f.info.name, "list of " + type, "none");
}

template <class T, class Variant>
std::string rows(const Alternatives<T, Variant>& f) {
    std::string names;
    for_each_alternative<Variant>([&]<class A>() { names += (names.empty() ? "" : ", ") + code(Fields<A>::name); });
    return row(f.info, f.info.name, names, "required");
}

// ---- tables --------------------------------------------------------------------------------------------------------

using Reference = std::vector<std::pair<std::string, std::string>>;

template <HasFields T>
void append(Reference& out, const std::string& title);

template <class V>
void append_used(Reference& out) {
    if constexpr (IsOptional<V>::value || IsList<V>::value)
        append_used<typename V::value_type>(out);
    else if constexpr (HasFields<V>)
        append<V>(out, std::string(Fields<V>::name));
}

// What a field is made of gets a table of its own.
template <class T, class M>
void append_parts(Reference& out, const Field<T, M>&) {
    append_used<M>(out);
}
template <class T, class Variant>
void append_parts(Reference& out, const Alternatives<T, Variant>&) {
    for_each_alternative<Variant>(
        [&]<class A>() { append<A>(out, std::string(Fields<T>::name) + ' ' + std::string(Fields<A>::name)); });
}
template <class Entry>
void append_parts(Reference&, const Entry&) {}

template <HasFields T>
void append(Reference& out, const std::string& title) {
    if (std::any_of(out.begin(), out.end(), [&](const auto& table) { return table.first == title; })) return;
    std::string table =
        std::string(Fields<T>::doc) +
        "\n\n| key | type | unit | default | range | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
    for_each_field<T>([&](const auto& entry) { table += rows(entry); });
    out.emplace_back(title, table);
    for_each_field<T>([&](const auto& entry) { append_parts(out, entry); });
}

}  // namespace

Reference scene_reference() {
    Reference out;
    append<SceneDesc>(out, "scene");
    return out;
}

}  // namespace drt
