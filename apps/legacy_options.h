#pragma once
// The options for what the legacy format leaves open, the same in every program that reads scenes.

#include <CLI/CLI.hpp>

#include "drt/formats/formats.h"

namespace drt {

/// Adds --fov, --gravity, --density, --legacy-step, --ambient-light and --add-lights, which write to `options`.
void add_legacy_options(CLI::App&, LegacyOptions& options);

}  // namespace drt
