#pragma once

#include <atomic>

namespace drt {

/// From now on SIGINT and SIGTERM end the process at once, as long as there is no picture to be saved, with the exit
/// codes of a render that they stop.
void install_signal_handlers();

/// From now on they raise `stop_requested()`: the renderer finishes the tiles at hand and the picture is written. A
/// second one ends the process at once.
void let_signals_stop_rendering();

const std::atomic<bool>& stop_requested();

/// The first signal received, or 0.
int received_signal();

}  // namespace drt
