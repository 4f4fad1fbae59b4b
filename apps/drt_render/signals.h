#pragma once

#include <atomic>

namespace drt {

/// From now on SIGINT and SIGTERM raise `stop_requested()`: the renderer finishes the tiles at hand and the picture is
/// written. A second one ends the process at once.
void install_signal_handlers();

const std::atomic<bool>& stop_requested();

/// The first signal received, or 0.
int received_signal();

}  // namespace drt
