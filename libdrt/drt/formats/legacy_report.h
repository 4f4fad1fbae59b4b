#pragma once
// Collects what is wrong or worth telling about one legacy file.

#include <string>
#include <string_view>

#include "drt/base/diagnostic.h"

namespace drt {

struct LegacyPlace {
    int line = 0, column = 0;
};

/// Collects diagnostics of one file; full after `max_errors` errors, which ends the parsing of hopeless files.
class LegacyReport {
public:
    static constexpr int max_errors = 100;
    explicit LegacyReport(std::string file) : file_(std::move(file)) {}
    void error(LegacyPlace, std::string message, std::string_view text = {}, std::string_view expected = {},
               std::string suggestion = {});
    void warning(LegacyPlace, std::string message, std::string_view text = {}, std::string_view expected = {});
    void note(LegacyPlace, std::string message);
    bool full() const { return errors_ > max_errors; }
    bool has_errors() const { return errors_ > 0; }
    Location location(LegacyPlace p) const { return {file_, p.line, p.column}; }
    Diagnostics take() { return std::move(diagnostics_); }

private:
    void add(Severity, LegacyPlace, std::string&& message, std::string_view text, std::string_view expected,
             std::string&& suggestion);
    std::string file_;
    Diagnostics diagnostics_;
    int errors_ = 0;
};

}  // namespace drt
