#include "drt/scene/check_fields.h"

#include <initializer_list>

namespace drt {
namespace {

std::string expected_number(const char* kind, const Range& range) {
    const std::string limits = to_string(range);
    return limits.empty() ? kind : kind + (' ' + limits);
}

// The first thing wrong with the numbers of a value, if any; true when there is.
template <class Value, class Number>
bool report_numbers(Report& report, const ScenePath& at, const FieldInfo& info, const Value& value,
                    std::initializer_list<Number> numbers, const char* kind) {
    for (const double v : numbers) {
        if (!std::isfinite(v))
            report.error(at, report.name(at, info.name) + " is not finite", to_text(value),
                         expected_number(kind, info.range));
        else if (!info.range.contains(v))
            report.error(at, report.name(at, info.name) + " is out of range", to_text(value),
                         expected_number(kind, info.range));
        else if (std::abs(v) > largest_number)
            report.error(at, report.name(at, info.name) + " is too large", to_text(value),
                         std::string(kind) + " of at most 1e15 in size");
        else
            continue;
        return true;
    }
    return false;
}

// "a.b[1].c" lies in "a", "a.b" and "a.b[1]", and in itself.
bool lies_in(std::string_view path, std::string_view whole) {
    if (!path.starts_with(whole)) return false;
    return path.size() == whole.size() || path[whole.size()] == '.' || path[whole.size()] == '[';
}

}  // namespace

bool FineFields::is_fine(const std::string& path) const {
    for (std::size_t i = first_; i < end_; ++i)
        if (lies_in(path, report_.error_paths[i]) || lies_in(report_.error_paths[i], path)) return false;
    return !report_.sources.is_unread(path);
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, double v) {
    report_numbers(report, at, info, v, {v}, "a number");
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, int v) {
    report_numbers(report, at, info, v, {v}, "an integer");
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const Vec3d& v) {
    if (report_numbers(report, at, info, v, {v.x, v.y, v.z}, "three numbers")) return;
    if (info.role == Role::direction && nearly_null(v))
        report.error(at, report.name(at, info.name) + " has no length", to_text(v), "a vector that is not zero");
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const Color& c) {
    report_numbers(report, at, info, c, {c.r, c.g, c.b}, "a colour of numbers");
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const Quatd& q) {
    if (report_numbers(report, at, info, q, {q.w, q.x, q.y, q.z}, "a quaternion of four numbers")) return;
    if (dot(q, q) < 1e-60)
        report.error(at, report.name(at, info.name) + " has no length", to_text(q), "a quaternion that is not zero");
}

void check_value(Report& report, const ScenePath& at, const FieldInfo& info, const std::string& text) {
    const bool reference = info.role == Role::material || info.role == Role::texture;
    if (text.empty() && info.presence == Presence::required && !reference)
        report.error(at, report.name(at, info.name) + " is empty", {}, info.role == Role::file ? "a file" : "a name");
    if (text.find('\0') != std::string::npos || find_invalid_utf8(text) != std::string::npos)
        report.error(at, report.name(at, info.name) + " is not UTF-8 text");
}

}  // namespace drt
