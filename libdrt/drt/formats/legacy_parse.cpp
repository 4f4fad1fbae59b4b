#include "drt/formats/legacy_parse.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "drt/formats/legacy_defaults.h"
#include "drt/formats/legacy_values.h"

namespace drt {
namespace {

using Kind = LegacyToken::Kind;

class Parser {
public:
    Parser(std::string_view text, LegacyReport& report) : in_{LegacyTokens(text), report} {}

    std::vector<LegacyElement> run() {
        while (in_.tokens.peek().kind != Kind::end && !in_.report.full()) top_level();
        ensure_settings();
        defaults_.tell(in_.report);
        return std::move(elements_);
    }

private:
    void top_level();
    void ensure_settings();
    void element(const LegacyElementType&, const LegacyToken& kind, const LegacyToken& name);
    void unknown_element(const LegacyToken& kind);
    bool open_body(const LegacyElementType&, std::string_view what, const LegacyToken& after);
    LegacyElement body(const LegacyElementType&, LegacyPlace);
    void attribute(LegacyElement&);
    int attribute_index(const LegacyElementType&, LegacyToken& name);
    void unknown_attribute(LegacyElement&, const LegacyToken& name);
    void read_value(LegacyElement&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    void read_number(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    void read_vector(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    void read_reference(LegacyElement&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    bool ends_body(const LegacyElementType&) const;

    LegacyInput in_;
    std::vector<LegacyElement> elements_;
    std::map<std::pair<const LegacyElementType*, std::string_view>, LegacyPlace> defined_;
    LegacyDefaults defaults_;
    struct Start {
        LegacyToken kind, name;
    };
    std::optional<Start> started_;  // an element whose kind and name have been read as an attribute
};

std::vector<std::string_view> element_names() {
    std::vector<std::string_view> names;
    for (const LegacyElementType& t : legacy_elements()) names.push_back(t.name);
    return names;
}

std::vector<std::string_view> attribute_names(const LegacyElementType& type) {
    std::vector<std::string_view> names;
    for (const LegacyAttribute& a : type.attributes) {
        names.push_back(a.name);
        for (const std::string_view alias : a.aliases)
            if (!alias.empty()) names.push_back(alias);
    }
    return names;
}

// ---- elements ------------------------------------------------------------------------------------------------------

void Parser::top_level() {
    if (started_) {
        const Start start = *std::exchange(started_, std::nullopt);
        return element(*find_legacy_element(start.kind.text), start.kind, start.name);
    }
    const LegacyToken kind = in_.tokens.next();
    if (kind.kind != Kind::word) {
        in_.report.error(place_of(kind), "a brace outside of any element", kind.text, "an element: kind name { ... }");
        if (kind.kind == Kind::open) skip_block(in_);
        return;
    }
    const LegacyElementType* type = find_legacy_element(kind.text);
    if (!type) return unknown_element(kind);
    LegacyToken name = in_.tokens.peek();
    if (name.kind == Kind::word) {
        in_.tokens.next();
    } else {
        in_.report.error(place_of(name), "a " + std::string(type->name) + " without a name", name.text,
                         std::string(type->name) + " name { ... }");
        name.text = {};
    }
    element(*type, kind, name);
}

void Parser::element(const LegacyElementType& type, const LegacyToken& kind, const LegacyToken& name) {
    if (!open_body(type, std::string(type.name) + ' ' + std::string(name.text), name)) return;
    LegacyElement e = body(type, place_of(kind));
    e.name = name.text;
    e.name_place = place_of(name);
    defaults_.fill(e, in_.report);
    if (!name.text.empty()) {
        const auto [it, is_new] = defined_.try_emplace({&type, name.text}, e.name_place);
        if (!is_new) {
            in_.report.error(e.name_place,
                             "a second " + std::string(type.name) + " of this name (the first is at line " +
                                 std::to_string(it->second.line) + ")",
                             name.text, "names that differ within a kind");
            return;
        }
    }
    elements_.push_back(std::move(e));
}

void Parser::unknown_element(const LegacyToken& kind) {
    const bool comment = kind.text.starts_with('#') || kind.text.starts_with("//") || kind.text.starts_with("/*");
    if (comment) {
        in_.report.error(place_of(kind), "the legacy format has no comments", kind.text, "an element");
        return in_.tokens.skip_line(kind.line);
    }
    in_.report.error(place_of(kind), "unknown element", kind.text, "settings, camera, a material, a body or a light",
                     nearest_word(kind.text, element_names()));
    // Most likely `kind name { ... }`: step over it as a whole. Else go on with the next word that is an element.
    while (in_.tokens.peek().kind == Kind::word && !find_legacy_element(in_.tokens.peek().text)) skip_token(in_);
    if (in_.tokens.peek().kind == Kind::open) {
        in_.tokens.next();
        skip_block(in_);
    }
}

bool Parser::open_body(const LegacyElementType& type, std::string_view what, const LegacyToken& after) {
    const LegacyToken& t = in_.tokens.peek();
    if (t.kind == Kind::open) {
        in_.tokens.next();
        return true;
    }
    in_.report.error(place_of(t.kind == Kind::end ? after : t), "missing \"{\" after " + std::string(what), t.text,
                     "\"{\"");
    // The attributes may follow all the same.
    return t.kind == Kind::word && find_legacy_attribute(type, t.text) >= 0;
}

LegacyElement Parser::body(const LegacyElementType& type, LegacyPlace place) {
    LegacyElement e{&type, {}, place, place, std::vector<LegacyValue>(type.attributes.size())};
    while (!in_.report.full()) {
        const LegacyToken t = started_ ? started_->kind : in_.tokens.peek();
        if (t.kind == Kind::close) {
            in_.tokens.next();
            break;
        }
        if (t.kind == Kind::end || started_ || ends_body(type)) {
            in_.report.error(
                place_of(t),
                "missing \"}\" of the " + std::string(type.name) + " that begins at line " + std::to_string(place.line),
                t.text, "\"}\"");
            break;
        }
        if (t.kind == Kind::open) {
            in_.report.error(place_of(t), "a brace where an attribute should be", t.text,
                             "an attribute of " + std::string(type.name));
            in_.tokens.next();
            skip_block(in_);
            continue;
        }
        attribute(e);
    }
    return e;
}

/// The word ahead begins another element, so a closing brace has been forgotten. (An attribute may be called like an
/// element: `texture X` inside a material_texture. Then it is the attribute.)
bool Parser::ends_body(const LegacyElementType& type) const {
    const LegacyToken& t = in_.tokens.peek();
    return t.kind == Kind::word && find_legacy_element(t.text) && find_legacy_attribute(type, t.text) < 0;
}

void Parser::ensure_settings() {
    const LegacyElementType* type = find_legacy_element("settings");
    for (const LegacyElement& e : elements_)
        if (e.type == type) return;
    LegacyElement e{type, {}, {}, {}, std::vector<LegacyValue>(type->attributes.size())};
    defaults_.fill(e, in_.report);
    elements_.push_back(std::move(e));
}

// ---- attributes ----------------------------------------------------------------------------------------------------

void Parser::attribute(LegacyElement& e) {
    LegacyToken name = in_.tokens.next();
    const int index = attribute_index(*e.type, name);
    if (index < 0) return unknown_attribute(e, name);
    const LegacyAttribute& a = e.type->attributes[size_t(index)];
    LegacyValue& value = e.values[size_t(index)];
    if (value.place.line != 0 && !a.repeats)
        in_.report.error(place_of(name),
                         "the attribute is given twice (first at line " + std::to_string(value.place.line) + ")",
                         name.text, "each attribute once");
    if (value.spelled.empty()) value.unread = false;
    value.spelled = name.text;
    read_value(e, a, name, value);
    refuse_more_numbers(in_, a);
}

/// Takes a blank for an underscore ("interpolate samples", as the manual's list has it) when that makes a name.
int Parser::attribute_index(const LegacyElementType& type, LegacyToken& name) {
    const int index = find_legacy_attribute(type, name.text);
    if (index >= 0 || in_.tokens.peek().kind != Kind::word || name.text.size() + in_.tokens.peek().text.size() > 64)
        return index;
    const std::string joined = std::string(name.text) + '_' + std::string(in_.tokens.peek().text);
    const int found = find_legacy_attribute(type, joined);
    if (found < 0) return -1;
    in_.tokens.next();
    name.text = type.attributes[size_t(found)].name;
    return found;
}

void Parser::unknown_attribute(LegacyElement& e, const LegacyToken& name) {
    const LegacyElementType& type = *e.type;
    for (LegacyValue& value : e.values)  // it may have been meant to be any of those that are not given
        if (value.spelled.empty()) value.unread = true;
    if (name.text.starts_with('#') || name.text.starts_with("//") || name.text.starts_with("/*")) {
        in_.report.error(place_of(name), "the legacy format has no comments", name.text, "an attribute");
        return in_.tokens.skip_line(name.line);
    }
    in_.report.error(place_of(name), "unknown attribute of " + std::string(type.name), name.text, {},
                     nearest_word(name.text, attribute_names(type)));
    // Its value: a block, or words up to the next attribute.
    if (in_.tokens.peek().kind == Kind::open) {
        in_.tokens.next();
        return skip_block(in_);
    }
    while (in_.tokens.peek().kind == Kind::word && !begins_something(in_, type)) skip_token(in_);
}

void Parser::read_value(LegacyElement& e, const LegacyAttribute& a, const LegacyToken& name, LegacyValue& value) {
    value.place = place_of(in_.tokens.peek());
    switch (a.type) {
        case LegacyType::real:
        case LegacyType::whole:
        case LegacyType::flag:
            read_number(*e.type, a, name, value);
            break;
        case LegacyType::vector:
        case LegacyType::color:
            read_vector(*e.type, a, name, value);
            break;
        case LegacyType::word:
            if (const auto word = read_legacy_word(in_, *e.type, a, name)) value.data = *word;
            break;
        case LegacyType::reference:
            read_reference(e, a, name, value);
            break;
        case LegacyType::event: {
            if (!open_body(legacy_force_event(), name.text, name)) break;
            LegacyElement event = body(legacy_force_event(), place_of(name));
            defaults_.fill(event, in_.report);
            if (auto* list = std::get_if<std::vector<LegacyElement>>(&value.data))
                list->push_back(std::move(event));
            else
                value.data = std::vector<LegacyElement>{std::move(event)};
            break;
        }
    }
}

void Parser::read_number(const LegacyElementType& type, const LegacyAttribute& a, const LegacyToken& name,
                         LegacyValue& value) {
    const auto number = read_legacy_number(in_, type, a, name);
    if (!number)
        value.unread = true;
    else if (a.minus_one && *number == -1)
        value.spelled = {};  // as if it had not been given
    else
        value.data = *number;
}

void Parser::read_vector(const LegacyElementType& type, const LegacyAttribute& a, const LegacyToken& name,
                         LegacyValue& value) {
    const auto v = read_legacy_vector(in_, type, a, name);
    if (!v)
        value.unread = true;
    else if (!a.repeats)
        value.data = *v;
    else if (auto* list = std::get_if<std::vector<Vec3d>>(&value.data))
        list->push_back(*v);
    else
        value.data = std::vector<Vec3d>{*v};
}

/// `texture X` is an attribute, `texture X {` the next element after a forgotten closing brace.
void Parser::read_reference(LegacyElement& e, const LegacyAttribute& a, const LegacyToken& name, LegacyValue& value) {
    const LegacyToken word = in_.tokens.peek();
    const auto referred = read_legacy_word(in_, *e.type, a, name);
    if (!referred) return;
    if (in_.tokens.peek().kind == Kind::open && find_legacy_element(name.text)) {
        started_ = Start{name, word};
        value = {};
    } else {
        value.data = *referred;
    }
}

}  // namespace

std::vector<LegacyElement> parse_legacy(std::string_view text, LegacyReport& report) {
    return Parser(text, report).run();
}

}  // namespace drt
