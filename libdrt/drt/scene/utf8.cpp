#include "drt/scene/utf8.h"

namespace drt {
namespace {

using Byte = unsigned char;

// Length of the well-formed sequence at the start of s, 0 if there is none. The second byte's range excludes overlong
// forms (E0, F0), surrogates (ED) and code points above U+10FFFF (F4).
std::size_t sequence_length(std::string_view s) {
    const Byte lead = Byte(s[0]);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xc2 && lead <= 0xdf   ? 2
                               : lead >= 0xe0 && lead <= 0xef ? 3
                               : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                              : 0;
    if (length == 0 || s.size() < length) return 0;
    const Byte low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const Byte high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (Byte(s[1]) < low || Byte(s[1]) > high) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if ((Byte(s[i]) & 0xc0) != 0x80) return 0;
    return length;
}

}  // namespace

std::size_t find_invalid_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = sequence_length(text.substr(i, 4));
        if (length == 0) return i;
        i += length;
    }
    return std::string_view::npos;
}

}  // namespace drt
