#include "drt/formats/text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace drt {

FileText read_file(const std::string& path, std::size_t max_bytes) {
    // fopen opens directories, and only reading them fails, with a text that puzzles
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) return {{}, "it is a directory", false};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!file) return {{}, std::strerror(errno), false};
    FileText out;
    constexpr std::size_t block = 1 << 20;
    for (;;) {
        const std::size_t size = out.text.size();
        out.text.resize(size + block);
        const std::size_t n = std::fread(out.text.data() + size, 1, block, file.get());
        out.text.resize(size + n);
        if (out.text.size() > max_bytes) return {{}, "it is too large", true};
        if (n < block) break;
    }
    if (std::ferror(file.get())) return {{}, std::strerror(errno), false};
    return out;
}

Location location_in(const std::string& file, std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const std::size_t newline = before.rfind('\n');
    const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    const auto is_start = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; };
    return {file, int(1 + std::count(before.begin(), before.end(), '\n')),
            int(1 + std::count_if(line.begin(), line.end(), is_start))};
}

std::string snippet(std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(std::min(offset, text.size()));
    return printable(rest.substr(0, std::min<std::size_t>(rest.find_first_of("\r\n"), 40)));
}

std::string word_at(std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(std::min(offset, text.size()));
    return printable(rest.substr(0, rest.find_first_of(" \t\r\n,]}")));
}

std::string printable(std::string_view text) {
    constexpr std::size_t longest = 60;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        // cut between characters, not inside one
        if (out.size() >= longest && (c & 0xc0) != 0x80) return out + "...";
        if (c >= 0x20 && c != 0x7f) {
            out += text[i];
        } else {
            char escaped[5];
            std::snprintf(escaped, sizeof escaped, "\\x%02x", c);
            out += escaped;
        }
    }
    return out;
}

}  // namespace drt
