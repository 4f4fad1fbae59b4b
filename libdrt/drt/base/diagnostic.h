#pragma once
// What is wrong with an input, where, and what was expected. Readers collect diagnostics and report all at once.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace drt {

/// A place in a text file. Lines and columns count from 1; line 0 means "the file as a whole".
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
    friend bool operator==(const Location&, const Location&) = default;
};

/// "file:line:column", "file" when the line is unknown, "" when the file is.
std::string to_string(const Location&);

enum class Severity { note, warning, error };

struct Diagnostic {
    Severity severity = Severity::error;
    Location where;
    std::string message;     ///< what is wrong: "unknown key"
    std::string text;        ///< the offending text as written: "radiuss" (may be empty)
    std::string expected;    ///< what was expected: "a number > 0" (may be empty)
    std::string suggestion;  ///< a near miss: "radius" (may be empty)
};

/// One line: `file:line:column: error: message "text"; expected ...; did you mean "..."?`
std::string to_string(const Diagnostic&);

using Diagnostics = std::vector<Diagnostic>;

bool has_errors(const Diagnostics&);

/// Why an input was refused. Maps to the documented exit codes (docs/exit-codes in the README).
enum class ErrorKind {
    usage,     ///< command line
    scene,     ///< the scene description is wrong
    asset,     ///< an input file (texture, include) is missing or unreadable
    output,    ///< a file cannot be written
    memory,    ///< out of memory
    internal,  ///< a bug
};

/// Every failure that drt reports to its caller. what() holds all diagnostics, a line each.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, Diagnostics diagnostics);
    Error(ErrorKind kind, std::string message);
    ErrorKind kind() const { return kind_; }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    ErrorKind kind_;
    Diagnostics diagnostics_;
};

/// The candidate nearest to `word` by edit distance (with transpositions), or "" when none is near enough to be a
/// plausible misspelling.
std::string nearest_word(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace drt
