#include "drt/formats/formats.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace drt {

SceneRead read_scene(const std::string& path, const LegacyOptions& options) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    if (extension == ".yaml" || extension == ".yml") return read_yaml_scene(path);
    try {
        return read_legacy_scene(path, options);
    } catch (const Error& e) {
        if (e.kind() != ErrorKind::scene) throw;
        Diagnostics all = e.diagnostics();  // who took it for YAML learns why nothing in it is right
        all.push_back({Severity::note,
                       {path, 0, 0},
                       "read as a legacy scene: its name does not end in .yaml or .yml",
                       {},
                       {},
                       {}});
        throw Error(e.kind(), std::move(all));
    }
}

}  // namespace drt
