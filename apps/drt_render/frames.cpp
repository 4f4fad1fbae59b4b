#include "frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string_view>
#include <unordered_set>

#include "drt/base/diagnostic.h"

namespace drt {

namespace {

constexpr size_t most_frames = 1000000;
constexpr int most_digits = 20;

[[noreturn]] void bad_frames(const std::string& text, const std::string& expected) {
    throw Error(ErrorKind::usage, {{Severity::error, {}, "bad frame list", text, expected, ""}});
}

// Takes digits from the front of `text`; nothing when there are none or too many for an int.
std::optional<int> take_number(std::string_view& text) {
    int value = 0;
    if (text.empty() || text.front() == '-') return {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc()) return {};
    text.remove_prefix(size_t(end - text.data()));
    return value;
}

bool take(std::string_view& text, char c) {
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
}

struct Range {
    int first = 0, last = 0, step = 1;
};

// "7", "1-100" or "1-100:2".
std::optional<Range> parse_range(std::string_view text) {
    const auto first = take_number(text);
    if (!first) return {};
    Range r{*first, *first, 1};
    if (take(text, '-')) {
        const auto last = take_number(text);
        if (!last || *last < r.first) return {};
        r.last = *last;
        if (take(text, ':')) {
            const auto step = take_number(text);
            if (!step || *step < 1) return {};
            r.step = *step;
        }
    }
    if (!text.empty()) return {};
    return r;
}

// The length of a frame token at the front of `text` and how many digits it asks for; length 0 when there is none.
struct Token {
    size_t length = 0;
    int digits = 0;
};

Token frame_token(std::string_view text) {
    const size_t hashes = std::min(text.find_first_not_of('#'), text.size());
    if (hashes > 0) return {hashes, int(std::min(hashes, size_t(most_digits)))};
    std::string_view rest = text;
    if (!take(rest, '%')) return {};
    const int digits = take_number(rest).value_or(1);
    if (!take(rest, 'd')) return {};
    return {text.size() - rest.size(), std::clamp(digits, 1, most_digits)};
}

}  // namespace

int parse_frame(const std::string& text) {
    std::string_view rest = text;
    const auto frame = take_number(rest);
    if (!frame || !rest.empty())
        throw Error(ErrorKind::usage, {{Severity::error, {}, "bad frame", text, "one number >= 0", ""}});
    return *frame;
}

std::vector<int> parse_frames(const std::string& text) {
    const std::string form = "N, A-B or A-B:STEP, separated by commas";
    std::vector<int> frames;
    std::unordered_set<int> seen;
    size_t begin = 0;
    while (begin <= text.size()) {
        const size_t comma = std::min(text.find(',', begin), text.size());
        const auto r = parse_range(std::string_view(text).substr(begin, comma - begin));
        if (!r) bad_frames(text, form);
        for (long long f = r->first; f <= r->last; f += r->step) {
            if (!seen.insert(int(f)).second) continue;
            if (frames.size() == most_frames) bad_frames(text, fmt::format("at most {} frames", most_frames));
            frames.push_back(int(f));
        }
        begin = comma + 1;
    }
    return frames;
}

std::string frame_path(const std::string& pattern, int frame, bool several_frames) {
    std::string path;
    bool found = false;
    for (size_t at = 0; at < pattern.size();) {
        const Token token = frame_token(std::string_view(pattern).substr(at));
        if (token.length == 0) {
            path += pattern[at++];
            continue;
        }
        path += fmt::format("{:0{}}", frame, token.digits);
        at += token.length;
        found = true;
    }
    if (found || !several_frames) return path;
    const std::filesystem::path p(pattern);
    return (p.parent_path() / fmt::format("{}.{:04}{}", p.stem().string(), frame, p.extension().string())).string();
}

}  // namespace drt
