#include "drt/base/diagnostic.h"

#include <algorithm>

namespace drt {

std::string to_string(const Location& l) {
    if (l.line <= 0) return l.file;
    return l.file + ':' + std::to_string(l.line) + ':' + std::to_string(l.column);
}

std::string to_string(const Diagnostic& d) {
    std::string out = to_string(d.where);
    if (!out.empty()) out += ": ";
    out += d.severity == Severity::error ? "error: " : d.severity == Severity::warning ? "warning: " : "note: ";
    out += d.message;
    if (!d.text.empty()) out += " \"" + d.text + '"';
    if (!d.expected.empty()) out += "; expected " + d.expected;
    if (!d.suggestion.empty()) out += "; did you mean \"" + d.suggestion + "\"?";
    return out;
}

bool has_errors(const Diagnostics& ds) {
    return std::any_of(ds.begin(), ds.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

namespace {

std::string join_lines(const Diagnostics& ds) {
    std::string out;
    for (const Diagnostic& d : ds) {
        if (!out.empty()) out += '\n';
        out += to_string(d);
    }
    return out;
}

// Optimal string alignment distance: insert, delete, replace, swap of neighbours, each 1.
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
    for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (size_t i = 1; i <= a.size(); ++i)
        for (size_t j = 1; j <= b.size(); ++j) {
            const size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

Error::Error(ErrorKind kind, Diagnostics diagnostics)
    : std::runtime_error(join_lines(diagnostics)), kind_(kind), diagnostics_(std::move(diagnostics)) {}

Error::Error(ErrorKind kind, std::string message)
    : Error(kind, Diagnostics{{Severity::error, {}, std::move(message), {}, {}, {}}}) {}

std::string nearest_word(std::string_view word, const std::vector<std::string_view>& candidates) {
    if (word.size() > 100) return {};
    size_t best = std::max<size_t>(1, word.size() / 3) + 1;
    std::string result;
    for (const std::string_view c : candidates) {
        const size_t distance = edit_distance(word, c);
        if (distance < best) {
            best = distance;
            result = c;
        }
    }
    return result;
}

}  // namespace drt
