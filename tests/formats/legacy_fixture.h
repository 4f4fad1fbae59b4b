#pragma once
// Reading legacy scenes from text in tests.

#include <gtest/gtest.h>

#include <string>

#include "drt/formats/formats.h"

namespace drt::legacy_test {

/// A camera and nothing else: the least that converts.
inline const std::string camera = "camera C { add_position { 0 0 5 } add_target { 0 0 0 } }\n";

/// The scene of a file "scene.txt" that holds `text`.
SceneRead read(const std::string& text, const LegacyOptions& = {});

/// All that is said of a text that cannot be read, a line each; "" when it can be read.
std::string errors_of(const std::string& text, const LegacyOptions& = {});
/// One line per warning and note.
std::string notes_of(const SceneRead&);

/// The notes hold one whose text contains `words`.
bool says(const SceneRead&, const std::string& words);

}  // namespace drt::legacy_test
