#pragma once
// A path into a SceneDesc, spelled as SourceMap's keys are ("bodies[3].radius").

#include <cstddef>
#include <string>
#include <string_view>

namespace drt {

/// A link of a path; the links before it live on the caller's stack, and the text is only made when asked for, so a
/// walk over a million bodies pays nothing for paths. A path must not outlive the one it was made from.
class ScenePath {
public:
    ScenePath() = default;  ///< the scene itself: ""
    ScenePath operator/(std::string_view name) const { return {this, name, 0}; }
    ScenePath operator[](std::size_t index) const { return {this, {}, index}; }
    std::string str() const;

private:
    ScenePath(const ScenePath* parent, std::string_view name, std::size_t index)
        : parent_(parent), name_(name), index_(index) {}
    void append_to(std::string& out) const;

    const ScenePath* parent_ = nullptr;
    std::string_view name_;  // empty: an index
    std::size_t index_ = 0;
};

}  // namespace drt
