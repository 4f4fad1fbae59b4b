#include "drt/formats/formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace drt {

SceneRead read_scene(const std::string& path, const LegacyOptions& options) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".yaml" || extension == ".yml" ? read_yaml_scene(path) : read_legacy_scene(path, options);
}

}  // namespace drt
