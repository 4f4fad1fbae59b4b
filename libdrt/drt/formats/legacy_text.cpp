#include "drt/formats/legacy_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "drt/formats/text_file.h"
#include "drt/scene/utf8.h"

namespace drt {
namespace {

// Code points of the bytes 0x80 to 0xFF in Windows-1250; 0 where it has none.
// clang-format off
constexpr std::array<std::uint16_t, 128> windows_1250{
    0x20AC, 0x0000, 0x201A, 0x0000, 0x201E, 0x2026, 0x2020, 0x2021, 0x0000, 0x2030, 0x0160, 0x2039,
    0x015A, 0x0164, 0x017D, 0x0179, 0x0000, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
    0x0000, 0x2122, 0x0161, 0x203A, 0x015B, 0x0165, 0x017E, 0x017A, 0x00A0, 0x02C7, 0x02D8, 0x0141,
    0x00A4, 0x0104, 0x00A6, 0x00A7, 0x00A8, 0x00A9, 0x015E, 0x00AB, 0x00AC, 0x00AD, 0x00AE, 0x017B,
    0x00B0, 0x00B1, 0x02DB, 0x0142, 0x00B4, 0x00B5, 0x00B6, 0x00B7, 0x00B8, 0x0105, 0x015F, 0x00BB,
    0x013D, 0x02DD, 0x013E, 0x017C, 0x0154, 0x00C1, 0x00C2, 0x0102, 0x00C4, 0x0139, 0x0106, 0x00C7,
    0x010C, 0x00C9, 0x0118, 0x00CB, 0x011A, 0x00CD, 0x00CE, 0x010E, 0x0110, 0x0143, 0x0147, 0x00D3,
    0x00D4, 0x0150, 0x00D6, 0x00D7, 0x0158, 0x016E, 0x00DA, 0x0170, 0x00DC, 0x00DD, 0x0162, 0x00DF,
    0x0155, 0x00E1, 0x00E2, 0x0103, 0x00E4, 0x013A, 0x0107, 0x00E7, 0x010D, 0x00E9, 0x0119, 0x00EB,
    0x011B, 0x00ED, 0x00EE, 0x010F, 0x0111, 0x0144, 0x0148, 0x00F3, 0x00F4, 0x0151, 0x00F6, 0x00F7,
    0x0159, 0x016F, 0x00FA, 0x0171, 0x00FC, 0x00FD, 0x0163, 0x02D9,
};
// clang-format on

/// Line and column of a byte, in bytes (before the text's encoding is known).
LegacyPlace place_of(std::string_view text, size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line_start = before.rfind('\n');
    return {1 + int(std::ranges::count(before, '\n')),
            int(line_start == before.npos ? offset + 1 : offset - line_start)};
}

bool is_control(unsigned char c) { return (c < 0x20 && !(c >= '\t' && c <= '\r')) || c == 0x7F; }

std::string hexadecimal(char c) { return fmt::format("0x{:02X}", static_cast<unsigned char>(c)); }

void append_utf8(std::string& out, std::uint16_t code) {
    if (code < 0x800) {
        out += char(0xC0 | (code >> 6));
    } else {
        out += char(0xE0 | (code >> 12));
        out += char(0x80 | ((code >> 6) & 0x3F));
    }
    out += char(0x80 | (code & 0x3F));
}

std::string from_windows_1250(std::string_view bytes, size_t invalid, LegacyReport& report) {
    const auto unknown =
        std::ranges::find_if(bytes, [](unsigned char c) { return c >= 0x80 && windows_1250[c - 0x80u] == 0; });
    if (unknown != bytes.end()) {
        report.error(place_of(bytes, size_t(unknown - bytes.begin())), "neither UTF-8 nor Windows-1250 text",
                     hexadecimal(*unknown), "a text file");
        return {};
    }
    std::string out;
    for (const char c : bytes) {
        if (static_cast<unsigned char>(c) < 0x80)
            out += c;
        else
            append_utf8(out, windows_1250[static_cast<unsigned char>(c) - 0x80u]);
    }
    report.note(place_of(bytes, invalid), "the file is not UTF-8; assumed: Windows-1250");
    return out;
}

}  // namespace

std::string read_legacy_file(const std::string& path) {
    const auto fail = [&](ErrorKind kind, const std::string& message) {
        Diagnostic d;
        d.where.file = path;
        d.message = message;
        throw Error(kind, Diagnostics{d});
    };
    FileText file = read_file(path, largest_legacy_file);
    if (file.too_large) fail(ErrorKind::scene, "the scene is larger than 64 MB");
    if (!file.problem.empty()) fail(ErrorKind::asset, "cannot read the scene: " + file.problem);
    return std::move(file.text);
}

std::string legacy_text(std::string bytes, LegacyReport& report) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        report.error({1, 1}, "the file is UTF-16", {}, "UTF-8 (or Windows-1250) text");
        return {};
    }
    const auto control = std::ranges::find_if(bytes, is_control);
    if (control != bytes.end()) {
        report.error(place_of(bytes, size_t(control - bytes.begin())), "not a text file: control character",
                     hexadecimal(*control), "a legacy scene");
        return {};
    }
    const size_t invalid = find_invalid_utf8(bytes);
    if (invalid == bytes.npos) return bytes;
    return from_windows_1250(bytes, invalid, report);
}

}  // namespace drt
