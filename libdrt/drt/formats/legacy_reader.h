#pragma once
// The legacy reader without the file system.

#include <string>

#include "drt/formats/formats.h"

namespace drt {

/// As read_legacy_scene(path), of a file that holds `bytes`.
SceneRead read_legacy_bytes(std::string bytes, const std::string& path, const LegacyOptions& = {});

}  // namespace drt
