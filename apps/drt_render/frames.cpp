#include "frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <regex>

#include "drt/base/diagnostic.h"

namespace drt {

namespace {

constexpr int most_frames = 1000000;

[[noreturn]] void bad_frames(const std::string& text) {
    throw Error(ErrorKind::usage,
                {{Severity::error, {}, "bad frame list", text, "N, A-B or A-B:STEP, separated by commas", ""}});
}

int to_frame(const std::string& digits, const std::string& whole) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) bad_frames(whole);
    return value;
}

}  // namespace

std::vector<int> parse_frames(const std::string& text) {
    static const std::regex part(R"((\d+)(?:-(\d+)(?::(\d+))?)?)");
    std::vector<int> frames;
    size_t begin = 0;
    while (begin <= text.size()) {
        const size_t comma = std::min(text.find(',', begin), text.size());
        const std::string item = text.substr(begin, comma - begin);
        std::smatch m;
        if (!std::regex_match(item, m, part)) bad_frames(text);
        const int first = to_frame(m[1], text);
        const int last = m[2].matched ? to_frame(m[2], text) : first;
        const int step = m[3].matched ? to_frame(m[3], text) : 1;
        if (last < first || step < 1 || (last - first) / step > most_frames) bad_frames(text);
        for (int f = first; f <= last && f >= first; f += step)
            if (std::find(frames.begin(), frames.end(), f) == frames.end()) frames.push_back(f);
        begin = comma + 1;
    }
    return frames;
}

std::string frame_path(const std::string& pattern, int frame, bool several_frames) {
    static const std::regex hashes("#+"), printf_token("%0?(\\d*)d");
    std::smatch m;
    if (std::regex_search(pattern, m, hashes))
        return fmt::format("{}{:0{}}{}", m.prefix().str(), frame, m.length(), m.suffix().str());
    if (std::regex_search(pattern, m, printf_token)) {
        const int digits = m[1].length() > 0 ? std::min(std::stoi(m[1]), 20) : 1;
        return fmt::format("{}{:0{}}{}", m.prefix().str(), frame, digits, m.suffix().str());
    }
    if (!several_frames) return pattern;
    const std::filesystem::path p(pattern);
    return (p.parent_path() / fmt::format("{}.{:04}{}", p.stem().string(), frame, p.extension().string())).string();
}

}  // namespace drt
