#include "drt/scene/scene_desc.h"

namespace drt {
namespace {

// "bodies[3].radius" -> "bodies[3]" -> "bodies" -> "".
void drop_last_link(std::string& path) {
    const size_t cut = path.find_last_of(".[");
    path.resize(cut == std::string::npos ? 0 : cut);
}

// "bodies[3].radius" -> "bodies[].radius".
std::string without_numbers(std::string_view path) {
    std::string out;
    bool in_brackets = false;
    for (const char c : path) {
        if (c == ']') in_brackets = false;
        if (!in_brackets) out += c;
        if (c == '[') in_brackets = true;
    }
    return out;
}

}  // namespace

void SourceMap::set_name(std::string_view path, std::string_view name) { names[without_numbers(path)] = name; }

std::string SourceMap::name(std::string_view path, std::string_view key) const {
    if (names.empty()) return std::string(key);
    std::string plain = without_numbers(path);
    const bool is_part = plain.ends_with(']') || plain.ends_with(".start") || plain.ends_with(".end");
    auto found = names.find(plain);
    if (found == names.end() && is_part) {
        drop_last_link(plain);
        found = names.find(plain);
    }
    return found == names.end() ? std::string(key) : found->second;
}

Location SourceMap::find(std::string path) const {
    for (; !path.empty(); drop_last_link(path))
        if (const auto it = places.find(path); it != places.end()) return it->second;
    const auto root = places.find("");
    return root == places.end() ? Location{} : root->second;
}

bool SourceMap::is_unread(std::string path) const {
    if (unread.empty()) return false;
    for (; !path.empty(); drop_last_link(path))
        if (unread.contains(path)) return true;
    return false;
}

}  // namespace drt
