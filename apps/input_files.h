#pragma once
// What a scene is read from is never written.

#include <string>
#include <unordered_map>
#include <unordered_set>

#include "drt/formats/formats.h"

namespace drt {

/// Names of files, one for each file, whatever links and dots lead to it.
using FileSet = std::unordered_set<std::string>;

/// Names files for a FileSet. A million frames lie in one folder, whose own name is found out once.
class FileNames {
public:
    std::string operator()(const std::string& path);

private:
    std::unordered_map<std::string, std::string> folders_;
};

/// Throws Error (usage) when an output is a file of the scene: its own, one that it includes, a texture or a sphere
/// set.
void check_inputs_kept(const FileSet& outputs, const SceneRead&);

}  // namespace drt
