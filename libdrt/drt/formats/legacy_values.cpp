#include "drt/formats/legacy_values.h"

#include <array>
#include <cmath>

#include "drt/formats/legacy_numbers.h"

namespace drt {
namespace {

using Kind = LegacyToken::Kind;

std::string quote(std::string_view text) { return '"' + std::string(text) + '"'; }

/// Reports a brace, the file's end or another attribute where the value of `name` should be.
bool value_is_missing(LegacyInput& in, const LegacyElementType& type, const LegacyAttribute& a,
                      const LegacyToken& name) {
    const LegacyToken& t = in.tokens.peek();
    if (t.kind == Kind::open) {
        in.report.error(place_of(t), quote(name.text) + " takes one value without braces", {}, legacy_expectation(a));
        in.tokens.next();
        skip_block(in);
        return true;
    }
    const bool is_word = a.type == LegacyType::word || a.type == LegacyType::reference;
    const bool is_next = t.kind != Kind::word || (!is_word && find_legacy_attribute(type, t.text) >= 0);
    if (is_next)
        in.report.error(place_of(t.kind == Kind::end ? name : t), quote(name.text) + " has no value", t.text,
                        legacy_expectation(a));
    return is_next;
}

/// What is wrong with a number's size, "" when nothing is. Says what is expected of one that is too large.
std::string range_fault(const LegacyAttribute& a, const LegacyToken& name, double value, std::string& expected) {
    if (legacy_in_range(a, value)) return {};
    const bool has_known_limits = a.type == LegacyType::whole || a.type == LegacyType::flag;
    if (has_known_limits || std::fabs(value) <= a.most) return quote(name.text) + " out of range";
    expected = legacy_size_expectation(a);
    return quote(name.text) + " too large";
}

struct Components {
    size_t count = 0;
    bool good = true;
};

/// The words of a vector. It ends before a word that begins something else: its closing brace has been forgotten.
Components read_components(LegacyInput& in, const LegacyElementType& type, const LegacyAttribute& a,
                           const LegacyToken& name, bool in_braces, std::array<double, 3>& v) {
    Components found;
    while (in.tokens.peek().kind == Kind::word) {
        const LegacyNumber number = parse_legacy_number(in.tokens.peek().text);
        std::string wrong(number.error), expected = "a number";
        if (!wrong.empty() && (!in_braces || begins_something(in, type))) break;
        const LegacyToken t = found.count < 3 ? in.tokens.next() : skip_token(in);
        if (wrong.empty()) wrong = range_fault(a, name, number.value, expected);
        if (!wrong.empty()) in.report.error(place_of(t), wrong, t.text, expected);
        found.good = found.good && wrong.empty();
        if (found.count < 3) v[found.count] = number.value;
        ++found.count;
    }
    return found;
}

}  // namespace

LegacyToken skip_token(LegacyInput& in) {
    constexpr size_t patience = 10000;
    const LegacyToken t = in.tokens.next();
    if (++in.skipped == patience) {
        in.report.error(place_of(t), "too much that cannot be read; nothing is read from here on");
        in.tokens.stop();
    }
    return t;
}

// Iterative: braces nest as deep as the file likes.
void skip_block(LegacyInput& in) {
    size_t depth = 1;
    while (depth > 0 && in.tokens.peek().kind != Kind::end) {
        const Kind kind = skip_token(in).kind;
        depth += kind == Kind::open;
        depth -= kind == Kind::close;
    }
}

bool begins_something(const LegacyInput& in, const LegacyElementType& type) {
    const std::string_view word = in.tokens.peek().text;
    return find_legacy_attribute(type, word) >= 0 || find_legacy_element(word);
}

std::optional<double> read_legacy_number(LegacyInput& in, const LegacyElementType& type, const LegacyAttribute& a,
                                         const LegacyToken& name) {
    if (value_is_missing(in, type, a, name)) return {};
    const LegacyToken t = in.tokens.next();
    const LegacyNumber number = parse_legacy_number(t.text);
    std::string wrong(number.error), expected = legacy_expectation(a);
    if (wrong.empty() && !(a.minus_one && number.value == -1)) wrong = range_fault(a, name, number.value, expected);
    if (wrong.empty()) return number.value;
    in.report.error(place_of(t), wrong, t.text, expected);
    return {};
}

std::optional<std::string_view> read_legacy_word(LegacyInput& in, const LegacyElementType& type,
                                                 const LegacyAttribute& a, const LegacyToken& name) {
    if (value_is_missing(in, type, a, name)) return {};
    return in.tokens.next().text;
}

std::optional<Vec3d> read_legacy_vector(LegacyInput& in, const LegacyElementType& type, const LegacyAttribute& a,
                                        const LegacyToken& name) {
    const LegacyToken first = in.tokens.peek();
    const bool open = first.kind == Kind::open;
    if (open)
        in.tokens.next();
    else
        in.report.error(place_of(first.kind == Kind::end ? name : first), "missing \"{\" after " + quote(name.text),
                        first.text, legacy_expectation(a));
    std::array<double, 3> v{};
    const Components found = read_components(in, type, a, name, open, v);
    if (!open) return {};
    const LegacyToken end = in.tokens.peek();
    const bool closed = end.kind == Kind::close;
    if (closed)
        in.tokens.next();
    else
        in.report.error(place_of(end), "missing \"}\" of " + quote(name.text), end.text, legacy_expectation(a));
    if (found.count != 3)
        in.report.error(place_of(first), quote(name.text) + " with " + std::to_string(found.count) + " numbers", {},
                        legacy_expectation(a));
    if (!closed || found.count != 3 || !found.good) return {};
    return Vec3d{v[0], v[1], v[2]};
}

void refuse_more_numbers(LegacyInput& in, const LegacyAttribute& a) {
    bool told = false;
    while (in.tokens.peek().kind == Kind::word && parse_legacy_number(in.tokens.peek().text).error.empty()) {
        const LegacyToken t = skip_token(in);
        if (!told)
            in.report.error(place_of(t), "too many numbers after " + quote(a.name), t.text, legacy_expectation(a));
        told = true;
    }
}

}  // namespace drt
