#pragma once
// Running drt-render in its tests, and looking at what it wrote.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drt/image/image.h"
#include "support/process.h"

namespace drt {

using test::ProcessOptions;
using test::ProcessResult;
using test::read_bytes;
using test::TempFolder;

/// A ball on a floor under a square lamp, 24 x 16 pixels, 4 samples a pixel. Frames 0 to 9 only.
extern const std::string small_scene;

ProcessResult render(const std::vector<std::string>& arguments, const ProcessOptions& = {});
/// The command runs in /bin/sh with "$0" = drt-render and "$@" = the arguments: for limits and redirections.
ProcessResult render_in_shell(const std::string& command, const std::vector<std::string>& arguments,
                              const ProcessOptions& = {});

/// Renders into <folder>/<name>.exr, expects success and returns the picture.
Image render_exr(const TempFolder&, const std::string& name, std::vector<std::string> arguments);

/// The texts and numbers among the attributes of an EXR file.
std::map<std::string, MetadataValue> exr_attributes(const std::string& path);

/// Whether it comes true within 30 seconds.
bool wait_until(const std::function<bool()>& condition);

std::vector<std::string> files_in(const TempFolder&);

/// `text` with one part replaced.
inline std::string replaced(std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << part << "\" is not in:\n" << text;
}

}  // namespace drt
