#pragma once
// Whole structs out of YAML mappings, by the tables of scene_fields.h. Internal to the formats room.

#include <algorithm>

#include "drt/formats/text_file.h"
#include "drt/formats/yaml_values.h"

namespace drt {

using Keys = std::vector<std::string_view>;

template <HasFields T>
bool read_value(YamlContext&, const YamlNode&, const ScenePath&, const FieldInfo&, T&);

/// Not made of other values.
template <class V>
inline constexpr bool is_single_value = !HasFields<V>;
template <class V>
inline constexpr bool is_single_value<std::optional<V>> = false;
template <class V>
inline constexpr bool is_single_value<std::vector<V>> = false;

/// As read_value, and notes a single value that cannot be read.
template <class V>
bool read_or_note(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, V& value) {
    const bool fine = read_value(context, node, at, info, value);
    if (!fine && is_single_value<V>) context.sources.unread.insert(at.str());
    return fine;
}

// ---- the keys of a struct ------------------------------------------------------------------------------------------

template <class T, class M>
void append_keys(Keys& keys, const Field<T, M>& f) {
    keys.push_back(f.info.name);
}
template <class T, class Start, class End>
void append_keys(Keys& keys, const StartEnd<T, Start, End>& f) {
    keys.push_back(f.info.name);
}
template <class T, class V>
void append_keys(Keys& keys, const OneOrMore<T, V>& f) {
    keys.push_back(f.singular);
    keys.push_back(f.info.name);
}
template <class T, class Variant>
void append_keys(Keys& keys, const Alternatives<T, Variant>& f) {
    keys.push_back(f.info.name);
}

template <class T>
Keys keys_of() {
    Keys keys;
    for_each_field<T>([&](const auto& entry) { append_keys(keys, entry); });
    return keys;
}

template <class Variant>
Keys type_names() {
    Keys names;
    for_each_alternative<Variant>([&]<class A>() { names.push_back(Fields<A>::name); });
    return names;
}

/// {radius: 1,5} is YAML for {radius: 1, 5: null}.
inline bool is_rest_of_number(const YamlNode& key, const YamlNode& value) {
    return value.kind == YamlNode::Kind::null && key.text.find_first_not_of("0123456789") == std::string::npos;
}

/// Reports the keys of a mapping that are not in `known`. `what` is whose keys they should be.
inline void check_unknown_keys(YamlContext& context, const YamlNode& mapping, const Keys& known,
                               const std::string& what) {
    for (std::size_t i = 0; i + 1 < mapping.items.size(); i += 2) {
        const YamlNode& key = *mapping.items[i];
        if (key.kind != YamlNode::Kind::scalar || key.text == "<<") continue;  // reported by the parser
        if (std::find(known.begin(), known.end(), key.text) != known.end()) continue;
        if (is_rest_of_number(key, *mapping.items[i + 1])) {
            context.error(key, "unknown key", key.text, "a point, not a comma, in a decimal number");
            continue;
        }
        const std::string suggestion = context.suggest(key.text, known);
        const std::string expected = "a key of " + what;
        context.error(key, "unknown key", printable(key.text),
                      suggestion.empty() ? expected + ": " + join(known) : expected, suggestion);
    }
}

inline void report_missing(YamlContext& context, const YamlNode& mapping, const FieldInfo& info,
                           std::string_view meaning) {
    const std::string name(info.name);
    context.error(mapping, "missing key", name, '`' + name + ": ...`, " + std::string(meaning));
}

// ---- values made of values -----------------------------------------------------------------------------------------

template <IsEnum E>
bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, E& value) {
    if (!context.note_value(at, node)) return false;
    const auto& names = EnumNames<E>::names;
    const std::optional<std::size_t> index = read_word(context, node, info, {names.begin(), names.end()});
    if (index) value = E(*index);
    return index.has_value();
}

template <class V>
bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info,
                std::optional<V>& value) {
    V v{};
    const bool fine = read_or_note(context, node, at, info, v);
    // what could be read of a struct is there to be checked
    if (fine || (HasFields<V> && node.kind == YamlNode::Kind::mapping)) value = std::move(v);
    return fine;
}

// What items of a list take from the item before, and what the first must therefore say.
template <class V>
void inherit(YamlContext& context, const YamlNode& node, const std::vector<V>& list, V& item) {
    for_each_field<V>([&](const auto& entry) {
        if (entry.info.presence != Presence::first_required) return;
        if constexpr (requires { item.*entry.member; }) {
            if (!list.empty())
                item.*entry.member = list.back().*entry.member;
            else if (node.kind == YamlNode::Kind::mapping && !find_value(node, entry.info.name))
                report_missing(context, node, entry.info, entry.info.doc);
        }
    });
}

/// Appends: the lists of included files come before those of the file that includes them.
template <class V>
bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info,
                std::vector<V>& list) {
    if (node.kind != YamlNode::Kind::list) {
        context.wrong_kind(node, info, "a list: `- ` before each item, or [] for none");
        context.sources.unread.insert(at.str());
        return false;
    }
    context.note_place(at, node);
    bool fine = true;
    for (const YamlNode* item_node : node.items) {
        V item{};
        if constexpr (HasFields<V>) inherit(context, *item_node, list, item);
        fine &= read_or_note(context, *item_node, at[list.size()], info, item);
        list.push_back(std::move(item));
    }
    return fine;
}

// ---- the entries of a table ----------------------------------------------------------------------------------------

template <class T, class M>
void read_entry(YamlContext& context, const YamlNode& mapping, const ScenePath& at, T& object, const Field<T, M>& f) {
    if (const YamlNode* value = find_value(mapping, f.info.name))
        read_or_note(context, *value, at / f.info.name, f.info, object.*f.member);
    else if (f.info.presence == Presence::required)
        report_missing(context, mapping, f.info, f.info.doc);
}

template <class T, class Start, class End>
void read_entry(YamlContext& context, const YamlNode& mapping, const ScenePath& at, T& object,
                const StartEnd<T, Start, End>& f) {
    const YamlNode* value = find_value(mapping, f.info.name);
    if (!value) return;
    const ScenePath here = at / f.info.name;
    if (value->kind != YamlNode::Kind::mapping) {
        read_or_note(context, *value, here / "start", f.info, object.*f.start);
        context.note_place(here, *value);
        return;
    }
    context.note_place(here, *value);
    check_unknown_keys(context, *value, {"start", "end"}, std::string(f.info.name));
    if (const YamlNode* start = find_value(*value, "start"))
        read_or_note(context, *start, here / "start", f.info, object.*f.start);
    if (const YamlNode* end = find_value(*value, "end"))
        read_or_note(context, *end, here / "end", f.info, object.*f.end);
}

template <class T, class V>
void read_entry(YamlContext& context, const YamlNode& mapping, const ScenePath& at, T& object,
                const OneOrMore<T, V>& f) {
    const YamlNode* one = find_value(mapping, f.singular);
    const YamlNode* more = find_value(mapping, f.info.name);
    const ScenePath here = at / f.info.name;
    if (one && more)
        context.error(*more, std::string(f.info.name) + " beside " + std::string(f.singular), {}, "one of the two");
    if (one) {
        V value{};
        FieldInfo info = f.info;
        info.name = f.singular;
        if (read_or_note(context, *one, here[0], info, value)) object.*f.member = {value};
        context.note_place(here, *one);
    } else if (more) {
        (object.*f.member).clear();
        read_or_note(context, *more, here, f.info, object.*f.member);
    }
}

template <class T, class Variant>
void read_entry(YamlContext& context, const YamlNode& mapping, const ScenePath& at, T& object,
                const Alternatives<T, Variant>& f) {
    const Keys names = type_names<Variant>();
    const YamlNode* type = find_value(mapping, f.info.name);
    if (!type) return report_missing(context, mapping, f.info, "one of " + join(names));
    context.note_place(at / f.info.name, *type);
    const std::optional<std::size_t> index = read_word(context, *type, f.info, names);
    if (!index) return;
    for_each_alternative<Variant>([&]<class A>() {
        if (Fields<A>::name != names[*index]) return;
        A alternative{};
        for_each_field<A>([&](const auto& entry) { read_entry(context, mapping, at, alternative, entry); });
        object.*f.member = std::move(alternative);
    });
}

// The keys that may stand in this very mapping: with an unknown type, those of every type.
template <class T, class Variant>
void append_alternative_keys(Keys& keys, std::string& what, const YamlNode& mapping,
                             const Alternatives<T, Variant>& f) {
    const YamlNode* type = find_value(mapping, f.info.name);
    const Keys names = type_names<Variant>();
    const bool known = type && std::find(names.begin(), names.end(), type->text) != names.end();
    if (known) what += " " + type->text;
    for_each_alternative<Variant>([&]<class A>() {
        if (known && Fields<A>::name != type->text) return;
        for (const std::string_view key : keys_of<A>())
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    });
}
template <class Entry>
void append_alternative_keys(Keys&, std::string&, const YamlNode&, const Entry&) {}

/// Reads the keys of T's table. `extra` are keys that the caller reads.
template <HasFields T>
void read_fields(YamlContext& context, const YamlNode& mapping, const ScenePath& at, T& object, const Keys& extra) {
    for_each_field<T>([&](const auto& entry) { read_entry(context, mapping, at, object, entry); });
    static const Keys own = keys_of<T>();
    Keys known = extra;
    known.insert(known.end(), own.begin(), own.end());
    std::string what(Fields<T>::name);
    for_each_field<T>([&](const auto& entry) { append_alternative_keys(known, what, mapping, entry); });
    check_unknown_keys(context, mapping, known, what);
}

template <HasFields T>
bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, T& object) {
    context.note_place(at, node);
    if (node.kind != YamlNode::Kind::mapping) {
        context.wrong_kind(node, info, "the keys of " + std::string(Fields<T>::name));
        return false;
    }
    const std::size_t before = context.out.size();
    read_fields(context, node, at, object, {});
    return context.out.size() == before;
}

}  // namespace drt
