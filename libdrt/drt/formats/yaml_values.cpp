#include "drt/formats/yaml_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drt/base/constants.h"
#include "drt/formats/number.h"
#include "drt/formats/text_file.h"
#include "drt/scene/value_text.h"

namespace drt {

void YamlContext::error(const YamlNode& at, std::string message, std::string text, std::string expected,
                        std::string suggestion) {
    out.push_back({Severity::error, tree.place(at), std::move(message), std::move(text), std::move(expected),
                   std::move(suggestion)});
}

std::string YamlContext::suggest(const std::string& word, const std::vector<std::string_view>& candidates) const {
    if (out.size() >= most_messages) return {};
    std::string nearest = nearest_word(word, candidates);
    if (nearest.empty() && word.size() >= 3)  // fov -> fov_degrees
        for (const std::string_view c : candidates)
            if (c.starts_with(word)) return std::string(c);
    return nearest;
}

void YamlContext::wrong_kind(const YamlNode& at, const FieldInfo& info, std::string expected) {
    const std::string name(info.name);
    switch (at.kind) {
        case YamlNode::Kind::null:
            return error(at, name + " has no value", {}, std::move(expected));
        case YamlNode::Kind::list:
            return error(at, name + " is a list", {}, std::move(expected));
        case YamlNode::Kind::mapping:
            return error(at, name + " is a mapping", {}, std::move(expected));
        case YamlNode::Kind::scalar:
            return error(at, name + (at.quoted ? " is a text in quotes" : " is a single value"), printable(at.text),
                         std::move(expected));
    }
}

void YamlContext::note_place(const ScenePath& path, const YamlNode& node) {
    sources.places.try_emplace(path.str(), tree.place(node));
}

bool YamlContext::note_value(const ScenePath& path, const YamlNode& node) {
    const auto [it, is_new] = sources.places.try_emplace(path.str(), tree.place(node));
    if (!is_new)
        error(node, "set a second time", it->first,
              "it in one file only; it was first set at " + to_string(it->second));
    return is_new;
}

std::string join(const std::vector<std::string_view>& words) {
    std::string out;
    for (const std::string_view w : words) {
        if (!out.empty()) out += ", ";
        out += w;
    }
    return out;
}

namespace {

// ---- numbers -------------------------------------------------------------------------------------------------------

std::string expected_number(const char* kind, const FieldInfo& info) {
    const std::string limits = to_string(info.range);
    return limits.empty() ? kind : kind + (' ' + limits);
}

// What was probably meant: 1,5 -> 1.5; 1_000 -> 1000; 010 -> 10; 0x10 -> 16.
std::string suggest_number(std::string text) {
    std::uint64_t whole = 0;
    if (text.starts_with("0x") || text.starts_with("0o")) {
        const auto r = std::from_chars(text.data() + 2, text.data() + text.size(), whole, text[1] == 'x' ? 16 : 8);
        return r.ec == std::errc{} && r.ptr == text.data() + text.size() ? std::to_string(whole) : std::string{};
    }
    std::erase(text, '_');
    if (const std::size_t comma = text.find(','); comma != std::string::npos) text[comma] = '.';
    while (text.size() > 1 && text[0] == '0' && text[1] != '.') text.erase(0, 1);
    double ignored;
    return parse_number(text, ignored) == NumberFault::none ? text : std::string{};
}

bool has_leading_zero(std::string_view text) {
    if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
    return text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
}

bool is_infinity_or_nan(std::string text) {
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    std::string_view rest = text;
    if (rest.starts_with('-') || rest.starts_with('+')) rest.remove_prefix(1);
    if (rest.starts_with('.')) rest.remove_prefix(1);
    return rest == "nan" || rest == "inf" || rest == "infinity";
}

template <class T>
bool parse_scalar(YamlContext& context, const YamlNode& node, const FieldInfo& info, T& value,
                  const std::string& expected) {
    if (node.kind != YamlNode::Kind::scalar || node.quoted) {
        context.wrong_kind(node, info, expected);
        return false;
    }
    const std::string name(info.name);
    if (has_leading_zero(node.text)) {  // YAML 1.1 reads 010 as 8, YAML 1.2 as 10
        context.error(node, name + " has a leading zero", printable(node.text), expected, suggest_number(node.text));
        return false;
    }
    const NumberFault fault = parse_number(node.text, value);
    if (fault == NumberFault::not_a_number)
        context.error(node, name + (is_infinity_or_nan(node.text) ? " is not finite" : " is not a number"),
                      printable(node.text), expected, suggest_number(node.text));
    if (fault == NumberFault::out_of_range)
        context.error(node, name + " does not fit into a floating-point number", printable(node.text), expected);
    return fault == NumberFault::none;
}

template <class T>
bool read_integer(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, T& value) {
    const std::string expected = expected_number("an integer", info);
    double number = 0;
    if (!context.note_value(at, node) || !parse_scalar(context, node, info, number, expected)) return false;
    constexpr double low = double(std::numeric_limits<T>::min()), high = double(std::numeric_limits<T>::max());
    if (number != std::floor(number)) {
        context.error(node, std::string(info.name) + " is not a whole number", printable(node.text), expected);
        return false;
    }
    if (number < low || number > high) {
        FieldInfo limited = info;
        limited.range = {.low = std::max(low, info.range.low), .high = std::min(high, info.range.high)};
        context.error(node, std::string(info.name) + " is out of range", printable(node.text),
                      expected_number("an integer", limited));
        return false;
    }
    value = T(number);
    return true;
}

// A list of N numbers. Reports each bad one at its own place.
template <class T, std::size_t N>
bool read_numbers(YamlContext& context, const YamlNode& node, const FieldInfo& info, std::array<T, N>& values,
                  const std::string& expected) {
    if (node.kind != YamlNode::Kind::list) {
        context.wrong_kind(node, info, expected);
        return false;
    }
    if (node.items.size() != N) {
        context.error(node, std::string(info.name) + " has " + std::to_string(node.items.size()) + " components", {},
                      expected);
        return false;
    }
    bool fine = true;
    for (std::size_t i = 0; i < N; ++i)
        fine &= parse_scalar(context, *node.items[i], info, values[i], expected_number("a number", info));
    return fine;
}

// ---- colours and orientations --------------------------------------------------------------------------------------

std::optional<Color> parse_hex_color(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return {};
    unsigned rgb = 0;
    const auto r = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
    if (r.ec != std::errc{} || r.ptr != text.data() + 7) return {};
    const auto channel = [rgb](int shift) { return srgb_to_linear(float((rgb >> shift) & 255) / 255); };
    return Color{channel(16), channel(8), channel(0)};
}

constexpr FieldInfo axis_info{"axis", "", ranges::any, ""};
constexpr FieldInfo degrees_info{"degrees", "", ranges::any, ""};

// {axis: [x, y, z], degrees: d}
bool read_axis_and_degrees(YamlContext& context, const YamlNode& node, const char* expected, Quatd& value) {
    bool fine = true;
    for (std::size_t i = 0; i + 1 < node.items.size(); i += 2) {
        const std::string& key = node.items[i]->text;
        if (key == "axis" || key == "degrees") continue;
        context.error(*node.items[i], "unknown key", printable(key), expected,
                      context.suggest(key, {"axis", "degrees"}));
        fine = false;
    }
    const YamlNode* axis_node = find_value(node, "axis");
    const YamlNode* degrees_node = find_value(node, "degrees");
    if (!axis_node || !degrees_node) {
        context.error(node, "missing key", axis_node ? "degrees" : "axis", expected);
        return false;
    }
    std::array<double, 3> a{};
    double turn = 0;
    fine &= read_numbers(context, *axis_node, axis_info, a, "[x, y, z]");
    fine &= parse_scalar(context, *degrees_node, degrees_info, turn, "a number");
    if (!fine) return false;
    const Vec3d axis{a[0], a[1], a[2]};
    if (!(length(axis) >= 1e-30 && length(axis) <= largest_number)) {
        context.error(*axis_node, "axis has no usable length", to_text(axis), "a vector that is not zero");
        return false;
    }
    value = quat_from_axis_angle(normalize(axis), radians(turn));
    return true;
}

}  // namespace

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, double& value) {
    return context.note_value(at, node) && parse_scalar(context, node, info, value, expected_number("a number", info));
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, int& value) {
    return read_integer(context, node, at, info, value);
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info,
                std::uint32_t& value) {
    return read_integer(context, node, at, info, value);
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, bool& value) {
    if (!context.note_value(at, node)) return false;
    if (node.kind != YamlNode::Kind::scalar || node.quoted || (node.text != "true" && node.text != "false")) {
        if (node.kind == YamlNode::Kind::scalar && !node.quoted)
            context.error(node, std::string(info.name) + " is neither true nor false", printable(node.text),
                          "true or false");
        else
            context.wrong_kind(node, info, "true or false");
        return false;
    }
    value = node.text == "true";
    return true;
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info,
                std::string& value) {
    if (!context.note_value(at, node)) return false;
    if (node.kind != YamlNode::Kind::scalar) {
        context.wrong_kind(node, info, info.role == Role::file ? "the name of a file" : "a name");
        return false;
    }
    value = node.text;
    if (info.role == Role::file && !value.empty()) value = (context.directory / value).lexically_normal().string();
    return true;
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, Vec3d& value) {
    std::array<double, 3> v{};
    if (!context.note_value(at, node) || !read_numbers(context, node, info, v, "[x, y, z]")) return false;
    value = {v[0], v[1], v[2]};
    return true;
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, Color& value) {
    const std::string expected = "[r, g, b], one number for a grey, or \"#rrggbb\" in quotes";
    if (!context.note_value(at, node)) return false;
    if (node.kind == YamlNode::Kind::list) {
        std::array<float, 3> c{};
        if (!read_numbers(context, node, info, c, expected)) return false;
        value = {c[0], c[1], c[2]};
        return true;
    }
    if (node.kind == YamlNode::Kind::scalar && node.text.starts_with('#')) {
        const std::optional<Color> color = parse_hex_color(node.text);
        if (!color)
            context.error(node, std::string(info.name) + " is not a colour", printable(node.text), expected);
        else
            value = *color;
        return color.has_value();
    }
    float grey = 0;
    if (!parse_scalar(context, node, info, grey, expected)) return false;
    value = Color{grey};
    return true;
}

bool read_value(YamlContext& context, const YamlNode& node, const ScenePath& at, const FieldInfo& info, Quatd& value) {
    constexpr const char* expected = "[w, x, y, z] or {axis: [x, y, z], degrees: d}";
    if (!context.note_value(at, node)) return false;
    if (node.kind == YamlNode::Kind::mapping) return read_axis_and_degrees(context, node, expected, value);
    std::array<double, 4> q{};
    if (!read_numbers(context, node, info, q, expected)) return false;
    value = {q[0], q[1], q[2], q[3]};
    return true;
}

std::optional<std::size_t> read_word(YamlContext& context, const YamlNode& node, const FieldInfo& info,
                                     const std::vector<std::string_view>& words) {
    if (node.kind != YamlNode::Kind::scalar) {
        context.wrong_kind(node, info, "one of " + join(words));
        return {};
    }
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == node.text) return i;
    context.error(node, "unknown " + std::string(info.name), printable(node.text), "one of " + join(words),
                  context.suggest(node.text, words));
    return {};
}

}  // namespace drt
