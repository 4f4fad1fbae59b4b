#include "signals.h"

#include <unistd.h>

#include <csignal>

#include "apps/exit_codes.h"

namespace drt {

namespace {

std::atomic<bool> renders{false}, stop{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

extern "C" void on_signal(int signal) {
    if (!renders) _exit(signal == SIGTERM ? exit_terminated : 128 + signal);
    if (stop.exchange(true)) _exit(128 + signal);
    first_signal = signal;
}

}  // namespace

void install_signal_handlers() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

void let_signals_stop_rendering() { renders = true; }
const std::atomic<bool>& stop_requested() { return stop; }
int received_signal() { return first_signal; }

}  // namespace drt
