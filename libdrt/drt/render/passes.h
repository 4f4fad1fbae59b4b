#pragma once
// How many samples per pixel each pass takes: 1, 1, 2, 4, 8, then 16 each, so that the first picture comes at once
// and the later ones cost little to synchronise.

#include <algorithm>

namespace drt {

inline constexpr int largest_pass = 16;

/// The size of the pass that begins when every pixel has `done` samples.
constexpr int pass_size(int done, int target) { return std::min(std::clamp(done, 1, largest_pass), target - done); }

/// The same under a time limit: the largest power of two that should still end in time, 0 if none does.
constexpr int pass_size_in_time(int done, int target, double seconds_per_sample, double seconds_left) {
    int size = pass_size(done, target);
    while (size > 0 && size * seconds_per_sample > seconds_left) size /= 2;
    return size;
}

}  // namespace drt
