#include "drt/formats/yaml_text.h"

#include <algorithm>

#include "drt/formats/text_file.h"
#include "drt/scene/utf8.h"

namespace drt {
namespace {

constexpr std::size_t most_tabs_reported = 20;
constexpr int deepest_brackets = 64;

bool is_utf16(std::string_view text) {
    return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
           text.substr(0, 4).find('\0') != std::string_view::npos;
}

bool is_control(char c) {
    const auto u = static_cast<unsigned char>(c);
    return (u < 0x20 && c != '\n' && c != '\r' && c != '\t') || u == 0x7f;
}

std::string hex(char c) {
    constexpr std::string_view digits = "0123456789abcdef";
    const auto u = static_cast<unsigned char>(c);
    return {'\\', 'x', digits[u >> 4], digits[u & 15]};
}

std::size_t find_control(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (is_control(text[i])) return i;
    return std::string_view::npos;
}

// A YAML parser looks ahead over all of them before it reports the first, and needs a few hundred bytes for each.
std::size_t find_nested_brackets(std::string_view text) {
    int run = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '[' || c == '{') {
            if (++run > deepest_brackets) return i;
        } else if (c != ' ' && c != '\n' && c != '\r') {
            run = 0;
        }
    }
    return std::string_view::npos;
}

void check_tabs(const std::string& file, std::string_view text, Diagnostics& out) {
    for (std::size_t line = 0; line < text.size() && out.size() < most_tabs_reported;) {
        const std::size_t content = std::min(text.find_first_not_of(" \t", line), text.size());
        const std::size_t tab = text.substr(0, content).find('\t', line);
        const bool blank = content == text.size() || text[content] == '\n' || text[content] == '\r';
        if (tab != std::string_view::npos && !blank && text[content] != '#')
            out.push_back({Severity::error,
                           location_in(file, text, tab),
                           "a tab in the indentation",
                           snippet(text, tab),
                           "spaces",
                           {}});
        const std::size_t end = text.find('\n', content);
        line = end == std::string_view::npos ? text.size() : end + 1;
    }
}

}  // namespace

std::string_view without_bom(std::string_view text) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    return text;
}

Diagnostics check_yaml_text(const std::string& file, std::string_view text) {
    const auto fault = [&](std::size_t at, const char* message, std::string shown, const char* expected) {
        return Diagnostics{{Severity::error, location_in(file, text, at), message, std::move(shown), expected, {}}};
    };
    if (is_utf16(text))
        return {{Severity::error, {file, 1, 1}, "the file is not UTF-8 but looks like UTF-16", {}, "UTF-8 text", {}}};
    if (const auto at = find_invalid_utf8(text); at != std::string_view::npos)
        return fault(at, "a byte that is not UTF-8", hex(text[at]), "UTF-8 text");
    if (const auto at = find_control(text); at != std::string_view::npos)
        return fault(at, "a control character", hex(text[at]), "text");
    if (const auto at = find_nested_brackets(text); at != std::string_view::npos)
        return fault(at, "nesting too deep", snippet(text, at), "at most 64 levels");
    Diagnostics out;
    check_tabs(file, text, out);
    return out;
}

}  // namespace drt
