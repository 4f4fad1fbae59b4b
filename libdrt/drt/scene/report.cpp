#include "drt/scene/report.h"

#include <utility>

namespace drt {

void Report::error(const ScenePath& at, std::string message, std::string text, std::string expected,
                   std::string suggestion) {
    error_paths.push_back(at.str());
    diagnostics.push_back({Severity::error, sources.find(error_paths.back()), std::move(message), std::move(text),
                           std::move(expected), std::move(suggestion)});
}

void Report::warning(const ScenePath& at, std::string message, std::string text, std::string expected) {
    diagnostics.push_back(
        {Severity::warning, sources.find(at.str()), std::move(message), std::move(text), std::move(expected), {}});
}

bool nearly_null(const Vec3d& v) { return length(v) < 1e-30; }

bool nearly_parallel(const Vec3d& a, const Vec3d& b) {
    if (nearly_null(a) || nearly_null(b)) return true;
    return length(cross(normalize(a), normalize(b))) < 1e-12;
}

}  // namespace drt
