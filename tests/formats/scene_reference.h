#pragma once
// The tables of docs/scene-format.md, made from the tables that the reader works by.

#include <string>
#include <utility>
#include <vector>

namespace drt {

/// Title ("camera", "body sphere", "light sphere") and Markdown table of every struct of a scene.
std::vector<std::pair<std::string, std::string>> scene_reference();

}  // namespace drt
