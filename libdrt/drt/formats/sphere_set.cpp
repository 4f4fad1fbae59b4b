// Reader of SphereSet files: `x y z radius` on each line, '#' starts a comment.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drt/formats/formats.h"
#include "drt/formats/number.h"
#include "drt/formats/text_file.h"
#include "drt/scene/fields.h"

namespace drt {
namespace {

constexpr std::size_t most_messages = 20;
constexpr std::string_view expected_line = "four numbers: x y z radius";

struct LineReader {
    const std::string& file;
    Diagnostics& errors;
    int number = 0;
    const char* begin = nullptr;

    bool fail(const char* at, const char* message, std::string_view rest, std::string_view expected) {
        const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r#"));
        errors.push_back({Severity::error,
                          {file, number, int(at - begin) + 1},
                          message,
                          printable(word),
                          std::string(expected),
                          {}});
        return false;
    }
    bool read(const char* end, std::vector<SphereRecord>& out);
};

const char* skip_blanks(const char* p, const char* end) {
    while (p != end && (*p == ' ' || *p == '\t' || *p == '\r')) ++p;
    return p;
}

bool is_delimiter(const char* p, const char* end) {
    return p == end || *p == ' ' || *p == '\t' || *p == '\r' || *p == '#';
}

bool LineReader::read(const char* end, std::vector<SphereRecord>& out) {
    std::array<double, 4> v{};
    const char* p = skip_blanks(begin, end);
    if (p == end || *p == '#') return true;
    for (std::size_t i = 0; i < 4; ++i) {
        p = skip_blanks(p, end);
        const char* const start = p;
        const std::string_view rest(start, std::size_t(end - start));
        if (p == end || *p == '#') return fail(p, "too few numbers", {}, expected_line);
        const NumberFault fault = parse_number(p, end, v[i]);
        if (fault == NumberFault::not_a_number || !is_delimiter(p, end))
            return fail(start, "not a number", rest, expected_line);
        if (fault == NumberFault::out_of_range || std::abs(v[i]) > largest_number)
            return fail(start, "number is too large", rest, "at most 1e15 in size");
        if (i == 3 && !(v[i] > 0)) return fail(start, "radius is out of range", rest, "a number > 0");
    }
    p = skip_blanks(p, end);
    if (p != end && *p != '#')
        return fail(p, "too many values", std::string_view(p, std::size_t(end - p)), expected_line);
    out.push_back({{v[0], v[1], v[2]}, v[3]});
    return true;
}

}  // namespace

std::vector<SphereRecord> read_sphere_set(const std::string& path) {
    const FileText file = read_file(path, std::numeric_limits<std::size_t>::max());
    if (!file.problem.empty())
        throw Error(ErrorKind::asset,
                    {{Severity::error, {path, 0, 0}, "cannot read the file (" + file.problem + ")", {}, {}, {}}});
    std::vector<SphereRecord> spheres;
    Diagnostics errors;
    LineReader line{path, errors};
    const char* const end = file.text.data() + file.text.size();
    for (const char* p = file.text.data(); p != end && errors.size() < most_messages;) {
        const char* const line_end = std::find(p, end, '\n');
        ++line.number;
        line.begin = p;
        line.read(line_end, spheres);
        p = line_end == end ? end : line_end + 1;
    }
    if (!errors.empty()) throw Error(ErrorKind::scene, std::move(errors));
    return spheres;
}

}  // namespace drt
