// A scene as YAML, by the tables of scene_fields.h, such that reading it gives the same scene again.

#include <fmt/format.h>

#include <filesystem>

#include "drt/formats/formats.h"
#include "drt/scene/scene_fields.h"
#include "drt/scene/utf8.h"
#include "drt/scene/value_text.h"

namespace drt {
namespace {

namespace fs = std::filesystem;

using Lines = std::vector<std::string>;

// ---- texts ---------------------------------------------------------------------------------------------------------

bool is_plain(std::string_view text) {
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    constexpr std::string_view others = "0123456789_-./";
    // words that some YAML reader takes for something else than a text
    for (const std::string_view word :
         {"null", "Null", "NULL", "true", "false", "True", "False", "TRUE", "FALSE", "yes", "no",
          "on",   "off",  "Yes",  "No",   "On",    "Off",  "y",     "n",    "Y",     "N"})
        if (text == word) return false;
    if (text.empty() || letters.find(text[0]) == std::string_view::npos) return false;
    for (const char c : text)
        if (letters.find(c) == std::string_view::npos && others.find(c) == std::string_view::npos) return false;
    return true;
}

std::string yaml_text(std::string_view text) {
    if (is_plain(text)) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            (out += '\\') += c;
        else if (u < 0x20 || u == 0x7f)
            out += fmt::format("\\x{:02x}", u);
        else
            out += c;
    }
    return out + '"';
}

// Relative where the file lies below the directory, or where both are relative: the scene can then move with its
// files.
std::string relative_file(const std::string& file, const std::string& directory) {
    const fs::path path(file), base(directory);
    if (file.empty()) return file;
    std::error_code ignored;
    const auto from = [&](const fs::path& p, const fs::path& b) {
        return p.lexically_normal().lexically_relative(b.empty() ? fs::path(".") : b.lexically_normal());
    };
    if (path.is_relative() && base.is_relative()) {
        const fs::path relative = from(path, base);
        return relative.empty() ? fs::absolute(path, ignored).lexically_normal().string() : relative.string();
    }
    const fs::path full = fs::absolute(path, ignored).lexically_normal();
    const fs::path relative = from(full, fs::absolute(base.empty() ? "." : base, ignored));
    const bool below = !relative.empty() && *relative.begin() != "..";
    return below ? relative.string() : full.string();
}

// ---- values --------------------------------------------------------------------------------------------------------

struct Writer {
    std::string directory;  // of the file that is written
};

template <class V>
std::string value_text(const Writer&, const FieldInfo&, const V& v) requires requires {
    to_text(v);
} &&(!HasFields<V>)&&(!IsEnum<V>) {
    return to_text(v);
}

template <IsEnum E>
std::string value_text(const Writer&, const FieldInfo&, E e) {
    return std::string(enum_name(e));
}

std::string value_text(const Writer& writer, const FieldInfo& info, const std::string& text) {
    return yaml_text(info.role == Role::file ? relative_file(text, writer.directory) : text);
}

// Small structs go into braces on one line: keys, turns, impulses and forces come in long lists.
template <class V>
constexpr bool is_compact = std::is_same_v<V, MotionKey> || std::is_same_v<V, Turn> ||
                            std::is_same_v<V, ImpulseEvent> || std::is_same_v<V, ForceEvent>;

template <HasFields T>
Lines struct_lines(const Writer&, const T&);

template <HasFields T>
std::string value_text(const Writer& writer, const FieldInfo&, const T& object) requires is_compact<T> {
    return fmt::format("{{{}}}", fmt::join(struct_lines(writer, object), ", "));
}

void append_indented(Lines& out, const Lines& lines, std::string_view first, std::string_view rest) {
    for (std::size_t i = 0; i < lines.size(); ++i) out.push_back(std::string(i == 0 ? first : rest) + lines[i]);
}

template <class V>
void append_pair(const Writer& writer, Lines& out, const FieldInfo& info, const V& value) {
    if constexpr (requires { value_text(writer, info, value); }) {
        out.push_back(fmt::format("{}: {}", info.name, value_text(writer, info, value)));
    } else {
        const Lines lines = struct_lines(writer, value);
        out.push_back(fmt::format("{}:{}", info.name, lines.empty() ? " {}" : ""));
        append_indented(out, lines, "  ", "  ");
    }
}

template <class V>
void append_pair(const Writer& writer, Lines& out, const FieldInfo& info, const std::optional<V>& value) {
    if (value) append_pair(writer, out, info, *value);
}

template <class V>
void append_pair(const Writer& writer, Lines& out, const FieldInfo& info, const std::vector<V>& list) {
    out.push_back(fmt::format("{}:{}", info.name, list.empty() ? " []" : ""));
    for (const V& item : list) {
        Lines lines;
        if constexpr (requires { value_text(writer, info, item); })
            lines = {value_text(writer, info, item)};
        else
            lines = struct_lines(writer, item);
        if (lines.empty()) lines = {"{}"};
        append_indented(out, lines, "  - ", "    ");
    }
}

// ---- entries of a table; what has its default is left out ----------------------------------------------------------

template <class T, class M>
void append_entry(const Writer& writer, Lines& out, const T& object, const Field<T, M>& f) {
    const bool always = f.info.presence != Presence::optional;
    if (always || !(object.*f.member == T{}.*f.member)) append_pair(writer, out, f.info, object.*f.member);
}

template <class T, class Start, class End>
void append_entry(const Writer& writer, Lines& out, const T& object, const StartEnd<T, Start, End>& f) {
    const Start& start = object.*f.start;
    const bool has_start = !(start == T{}.*f.start);
    if (!(object.*f.end)) {
        if (has_start) append_pair(writer, out, f.info, start);
        return;
    }
    Lines both;
    FieldInfo info = f.info;
    info.name = "start";
    if (has_start) append_pair(writer, both, info, start);
    info.name = "end";
    append_pair(writer, both, info, object.*f.end);
    out.push_back(fmt::format("{}: {{{}}}", f.info.name, fmt::join(both, ", ")));
}

template <class T, class V>
void append_entry(const Writer& writer, Lines& out, const T& object, const OneOrMore<T, V>& f) {
    const std::vector<V>& list = object.*f.member;
    if (list == T{}.*f.member) return;
    FieldInfo info = f.info;
    if (list.size() != 1) return append_pair(writer, out, info, list);
    info.name = f.singular;
    append_pair(writer, out, info, list.front());
}

template <class T, class Variant>
void append_entry(const Writer& writer, Lines& out, const T& object, const Alternatives<T, Variant>& f) {
    std::visit(
        [&]<class A>(const A& alternative) {
            out.push_back(fmt::format("{}: {}", f.info.name, Fields<A>::name));
            append_indented(out, struct_lines(writer, alternative), "", "");
        },
        object.*f.member);
}

template <HasFields T>
Lines struct_lines(const Writer& writer, const T& object) {
    Lines out;
    for_each_field<T>([&](const auto& entry) { append_entry(writer, out, object, entry); });
    return out;
}

// A comment may hold whatever the user's old file did, but YAML must stay UTF-8 without control characters.
std::string comment_line(std::string_view line) {
    const bool is_utf8 = find_invalid_utf8(line) == std::string_view::npos;
    std::string out = line.empty() ? "#" : "# ";
    for (const char c : line) {
        const auto u = static_cast<unsigned char>(c);
        out += u < 0x20 || u == 0x7f || (u >= 0x80 && !is_utf8) ? '?' : c;
    }
    return out + '\n';
}

std::string comment(std::string_view header) {
    std::string out;
    for (std::size_t begin = 0; begin < header.size();) {
        const std::size_t end = std::min(header.find('\n', begin), header.size());
        out += comment_line(header.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

}  // namespace

std::string write_yaml_scene(const SceneDesc& scene, const std::string& directory, const std::string& header) {
    std::string out = comment(header) + "drt: 1\n";
    for (const std::string& line : struct_lines(Writer{directory}, scene)) {
        if (line[0] != ' ' && line.back() == ':') out += '\n';  // a blank line before each section
        (out += line) += '\n';
    }
    return out;
}

}  // namespace drt
