#include "drt/formats/legacy_parse.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "drt/formats/legacy_defaults.h"
#include "drt/formats/legacy_numbers.h"
#include "drt/formats/legacy_tokens.h"

namespace drt {
namespace {

using Kind = LegacyToken::Kind;

LegacyPlace place_of(const LegacyToken& t) { return {t.line, t.column}; }

std::string quote(std::string_view text) { return '"' + std::string(text) + '"'; }

class Parser {
public:
    Parser(std::string_view text, LegacyReport& report) : tokens_(text), report_(report) {}

    std::vector<LegacyElement> run() {
        while (tokens_.peek().kind != Kind::end && !report_.full()) top_level();
        ensure_settings();
        defaults_.tell(report_);
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
    void unknown_attribute(const LegacyElementType&, const LegacyToken& name);
    void read_value(LegacyElement&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    std::optional<double> read_number(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name);
    std::optional<Vec3d> read_vector(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name);
    struct Components {
        size_t count = 0;
        bool good = true;
    };
    Components read_components(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name,
                               bool in_braces, std::array<double, 3>&);
    std::optional<std::string_view> read_word(const LegacyElementType&, const LegacyAttribute&, const LegacyToken&);
    void read_reference(LegacyElement&, const LegacyAttribute&, const LegacyToken& name, LegacyValue&);
    bool value_is_missing(const LegacyElementType&, const LegacyAttribute&, const LegacyToken& name);
    void check_no_leftovers(const LegacyAttribute&);
    bool ends_body(const LegacyElementType&) const;
    bool begins_something(const LegacyElementType&) const;
    LegacyToken skip();
    void skip_block();

    LegacyTokens tokens_;
    LegacyReport& report_;
    size_t skipped_ = 0;  // tokens, over the whole file
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
    const LegacyToken kind = tokens_.next();
    if (kind.kind != Kind::word) {
        report_.error(place_of(kind), "a brace outside of any element", kind.text, "an element: kind name { ... }");
        if (kind.kind == Kind::open) skip_block();
        return;
    }
    const LegacyElementType* type = find_legacy_element(kind.text);
    if (!type) return unknown_element(kind);
    LegacyToken name = tokens_.peek();
    if (name.kind == Kind::word) {
        tokens_.next();
    } else {
        report_.error(place_of(name), "a " + std::string(type->name) + " without a name", name.text,
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
    defaults_.fill(e, report_);
    if (!name.text.empty()) {
        const auto [it, is_new] = defined_.try_emplace({&type, name.text}, e.name_place);
        if (!is_new) {
            report_.error(e.name_place,
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
        report_.error(place_of(kind), "the legacy format has no comments", kind.text, "an element");
        return tokens_.skip_line(kind.line);
    }
    report_.error(place_of(kind), "unknown element", kind.text, "settings, camera, a material, a body or a light",
                  nearest_word(kind.text, element_names()));
    // Most likely `kind name { ... }`: step over it as a whole. Else go on with the next word that is an element.
    while (tokens_.peek().kind == Kind::word && !find_legacy_element(tokens_.peek().text)) skip();
    if (tokens_.peek().kind == Kind::open) {
        tokens_.next();
        skip_block();
    }
}

bool Parser::open_body(const LegacyElementType& type, std::string_view what, const LegacyToken& after) {
    const LegacyToken& t = tokens_.peek();
    if (t.kind == Kind::open) {
        tokens_.next();
        return true;
    }
    report_.error(place_of(t.kind == Kind::end ? after : t), "missing \"{\" after " + std::string(what), t.text,
                  "\"{\"");
    // The attributes may follow all the same.
    return t.kind == Kind::word && find_legacy_attribute(type, t.text) >= 0;
}

LegacyElement Parser::body(const LegacyElementType& type, LegacyPlace place) {
    LegacyElement e{&type, {}, place, place, std::vector<LegacyValue>(type.attributes.size())};
    while (!report_.full()) {
        const LegacyToken t = started_ ? started_->kind : tokens_.peek();
        if (t.kind == Kind::close) {
            tokens_.next();
            break;
        }
        if (t.kind == Kind::end || started_ || ends_body(type)) {
            report_.error(
                place_of(t),
                "missing \"}\" of the " + std::string(type.name) + " that begins at line " + std::to_string(place.line),
                t.text, "\"}\"");
            break;
        }
        if (t.kind == Kind::open) {
            report_.error(place_of(t), "a brace where an attribute should be", t.text,
                          "an attribute of " + std::string(type.name));
            tokens_.next();
            skip_block();
            continue;
        }
        attribute(e);
    }
    return e;
}

/// The word ahead begins another element, so a closing brace has been forgotten. (An attribute may be called like an
/// element: `texture X` inside a material_texture. Then it is the attribute.)
bool Parser::ends_body(const LegacyElementType& type) const {
    const LegacyToken& t = tokens_.peek();
    return t.kind == Kind::word && find_legacy_element(t.text) && find_legacy_attribute(type, t.text) < 0;
}

/// The word ahead is an attribute of the element, or another element.
bool Parser::begins_something(const LegacyElementType& type) const {
    const std::string_view word = tokens_.peek().text;
    return find_legacy_attribute(type, word) >= 0 || find_legacy_element(word);
}

/// The next token, of no use. Recovery from errors gives up on files that are nothing but nonsense.
LegacyToken Parser::skip() {
    constexpr size_t patience = 10000;
    const LegacyToken t = tokens_.next();
    if (++skipped_ == patience) {
        report_.error(place_of(t), "too much that cannot be read; nothing is read from here on");
        tokens_.stop();
    }
    return t;
}

// Iterative: braces nest as deep as the file likes.
void Parser::skip_block() {
    size_t depth = 1;
    while (depth > 0 && tokens_.peek().kind != Kind::end) {
        const Kind kind = skip().kind;
        depth += kind == Kind::open;
        depth -= kind == Kind::close;
    }
}

void Parser::ensure_settings() {
    const LegacyElementType* type = find_legacy_element("settings");
    for (const LegacyElement& e : elements_)
        if (e.type == type) return;
    LegacyElement e{type, {}, {}, {}, std::vector<LegacyValue>(type->attributes.size())};
    defaults_.fill(e, report_);
    elements_.push_back(std::move(e));
}

// ---- attributes ----------------------------------------------------------------------------------------------------

void Parser::attribute(LegacyElement& e) {
    LegacyToken name = tokens_.next();
    const int index = attribute_index(*e.type, name);
    if (index < 0) return unknown_attribute(*e.type, name);
    const LegacyAttribute& a = e.type->attributes[size_t(index)];
    LegacyValue& value = e.values[size_t(index)];
    if (value.place.line != 0 && !a.repeats)
        report_.error(place_of(name),
                      "the attribute is given twice (first at line " + std::to_string(value.place.line) + ")",
                      name.text, "each attribute once");
    value.spelled = name.text;
    read_value(e, a, name, value);
    check_no_leftovers(a);
}

/// Takes a blank for an underscore ("interpolate samples", as the manual's list has it) when that makes a name.
int Parser::attribute_index(const LegacyElementType& type, LegacyToken& name) {
    const int index = find_legacy_attribute(type, name.text);
    if (index >= 0 || tokens_.peek().kind != Kind::word || name.text.size() + tokens_.peek().text.size() > 64)
        return index;
    const std::string joined = std::string(name.text) + '_' + std::string(tokens_.peek().text);
    const int found = find_legacy_attribute(type, joined);
    if (found < 0) return -1;
    tokens_.next();
    name.text = type.attributes[size_t(found)].name;
    return found;
}

void Parser::unknown_attribute(const LegacyElementType& type, const LegacyToken& name) {
    if (name.text.starts_with('#') || name.text.starts_with("//") || name.text.starts_with("/*")) {
        report_.error(place_of(name), "the legacy format has no comments", name.text, "an attribute");
        return tokens_.skip_line(name.line);
    }
    report_.error(place_of(name), "unknown attribute of " + std::string(type.name), name.text, {},
                  nearest_word(name.text, attribute_names(type)));
    // Its value: a block, or words up to the next attribute.
    if (tokens_.peek().kind == Kind::open) {
        tokens_.next();
        return skip_block();
    }
    while (tokens_.peek().kind == Kind::word && !begins_something(type)) skip();
}

void Parser::read_value(LegacyElement& e, const LegacyAttribute& a, const LegacyToken& name, LegacyValue& value) {
    value.place = place_of(tokens_.peek());
    switch (a.type) {
        case LegacyType::real:
        case LegacyType::whole:
        case LegacyType::flag:
            if (const auto number = read_number(*e.type, a, name)) {
                if (a.minus_one && *number == -1)
                    value.spelled = {};  // as if it had not been given
                else
                    value.data = *number;
            }
            break;
        case LegacyType::vector:
        case LegacyType::color:
            if (const auto v = read_vector(*e.type, a, name)) {
                if (!a.repeats)
                    value.data = *v;
                else if (auto* list = std::get_if<std::vector<Vec3d>>(&value.data))
                    list->push_back(*v);
                else
                    value.data = std::vector<Vec3d>{*v};
            }
            break;
        case LegacyType::word:
            if (const auto word = read_word(*e.type, a, name)) value.data = *word;
            break;
        case LegacyType::reference:
            read_reference(e, a, name, value);
            break;
        case LegacyType::event: {
            if (!open_body(legacy_force_event(), name.text, name)) break;
            LegacyElement event = body(legacy_force_event(), place_of(name));
            defaults_.fill(event, report_);
            if (auto* list = std::get_if<std::vector<LegacyElement>>(&value.data))
                list->push_back(std::move(event));
            else
                value.data = std::vector<LegacyElement>{std::move(event)};
            break;
        }
    }
}

/// Reports a brace, the file's end or another attribute where the value of `name` should be.
bool Parser::value_is_missing(const LegacyElementType& type, const LegacyAttribute& a, const LegacyToken& name) {
    const LegacyToken& t = tokens_.peek();
    if (t.kind == Kind::open) {
        report_.error(place_of(t), quote(name.text) + " takes one value without braces", {}, legacy_expectation(a));
        tokens_.next();
        skip_block();
        return true;
    }
    const bool is_word = a.type == LegacyType::word || a.type == LegacyType::reference;
    const bool is_next = t.kind != Kind::word || (!is_word && find_legacy_attribute(type, t.text) >= 0);
    if (is_next)
        report_.error(place_of(t.kind == Kind::end ? name : t), quote(name.text) + " has no value", t.text,
                      legacy_expectation(a));
    return is_next;
}

std::optional<double> Parser::read_number(const LegacyElementType& type, const LegacyAttribute& a,
                                          const LegacyToken& name) {
    if (value_is_missing(type, a, name)) return {};
    const LegacyToken t = tokens_.next();
    const LegacyNumber number = parse_legacy_number(t.text);
    std::string wrong(number.error);
    if (wrong.empty()) {
        if (a.minus_one && number.value == -1) return number.value;
        if (legacy_in_range(a, number.value)) return number.value;
        wrong = quote(name.text) + " out of range";
    }
    report_.error(place_of(t), wrong, t.text, legacy_expectation(a));
    return {};
}

std::optional<std::string_view> Parser::read_word(const LegacyElementType& type, const LegacyAttribute& a,
                                                  const LegacyToken& name) {
    if (value_is_missing(type, a, name)) return {};
    return tokens_.next().text;
}

/// `texture X` is an attribute, `texture X {` the next element after a forgotten closing brace.
void Parser::read_reference(LegacyElement& e, const LegacyAttribute& a, const LegacyToken& name, LegacyValue& value) {
    const LegacyToken word = tokens_.peek();
    const auto referred = read_word(*e.type, a, name);
    if (!referred) return;
    if (tokens_.peek().kind == Kind::open && find_legacy_element(name.text)) {
        started_ = Start{name, word};
        value = {};
    } else {
        value.data = *referred;
    }
}

std::optional<Vec3d> Parser::read_vector(const LegacyElementType& type, const LegacyAttribute& a,
                                         const LegacyToken& name) {
    const LegacyToken first = tokens_.peek();
    const bool open = first.kind == Kind::open;
    if (open)
        tokens_.next();
    else
        report_.error(place_of(first.kind == Kind::end ? name : first), "missing \"{\" after " + quote(name.text),
                      first.text, legacy_expectation(a));
    std::array<double, 3> v{};
    const Components found = read_components(type, a, name, open, v);
    if (!open) return {};
    const LegacyToken end = tokens_.peek();
    const bool closed = end.kind == Kind::close;
    if (closed)
        tokens_.next();
    else
        report_.error(place_of(end), "missing \"}\" of " + quote(name.text), end.text, legacy_expectation(a));
    if (found.count != 3)
        report_.error(place_of(first), quote(name.text) + " with " + std::to_string(found.count) + " numbers", {},
                      legacy_expectation(a));
    if (!closed || found.count != 3 || !found.good) return {};
    return Vec3d{v[0], v[1], v[2]};
}

/// The words of a vector. It ends before a word that begins something else: its closing brace has been forgotten.
Parser::Components Parser::read_components(const LegacyElementType& type, const LegacyAttribute& a,
                                           const LegacyToken& name, bool in_braces, std::array<double, 3>& v) {
    Components found;
    while (tokens_.peek().kind == Kind::word) {
        const LegacyNumber number = parse_legacy_number(tokens_.peek().text);
        std::string wrong(number.error);
        if (!wrong.empty() && (!in_braces || begins_something(type))) break;
        const LegacyToken t = found.count < 3 ? tokens_.next() : skip();
        if (wrong.empty() && !legacy_in_range(a, number.value)) wrong = quote(name.text) + " out of range";
        if (!wrong.empty()) report_.error(place_of(t), wrong, t.text, "a number");
        found.good = found.good && wrong.empty();
        if (found.count < 3) v[found.count] = number.value;
        ++found.count;
    }
    return found;
}

/// `radius 4 5`, `position { 1 2 3 } 4`: a number is never the name of an attribute.
void Parser::check_no_leftovers(const LegacyAttribute& a) {
    bool told = false;
    while (tokens_.peek().kind == Kind::word && parse_legacy_number(tokens_.peek().text).error.empty()) {
        const LegacyToken t = skip();
        if (!told) report_.error(place_of(t), "too many numbers after " + quote(a.name), t.text, legacy_expectation(a));
        told = true;
    }
}

}  // namespace

std::vector<LegacyElement> parse_legacy(std::string_view text, LegacyReport& report) {
    return Parser(text, report).run();
}

}  // namespace drt
