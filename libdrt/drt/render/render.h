#pragma once
// Progressive rendering of one frame: passes over the whole picture, tiles in parallel, until a stopping rule fires.
// After any pass the film is a valid picture.

#include <atomic>
#include <functional>
#include <string_view>

#include "drt/film/error_estimate.h"
#include "drt/plan/plan.h"
#include "drt/render/memory.h"
#include "drt/stages/stage.h"

namespace drt {

struct RenderOptions {
    int spp = 64;           ///< stop at this many samples per pixel
    double time_limit = 0;  ///< seconds; 0 = none. At least one sample per pixel is taken whatever the limit.
    int threads = 0;        ///< 0 = all
    int tile_size = 32;     ///< pixels; a power of two. The picture does not depend on it.
    std::optional<std::size_t> memory_limit;  ///< bytes that may be allocated; none: nine tenths of what is available
    const std::atomic<bool>* stop = nullptr;  ///< set from outside: finish the tiles at hand and return
};

enum class StopReason { samples, time_limit, interrupted };
std::string_view describe(StopReason);

struct Progress {
    double fraction = 0;  ///< of the work asked for, by the stopping rule that is nearest
    int spp_done = 0;     ///< samples that every pixel has
    double seconds = 0;
};

/// Called between passes and, for `progress`, also within them, always from the calling thread's arena, one at a time.
struct RenderEvents {
    std::function<void(const Progress&)> progress;
    std::function<void(const Film&, const Progress&)> pass_done;
};

/// What is known of a picture's error.
enum class PictureKnown {
    error,           ///< the estimate
    error_at_least,  ///< the estimate, from below
    nothing_hit,     ///< no camera ray met anything: there may be nothing, or it is too small
    all_dropped,     ///< no sample is a number
    one_replicate,   ///< too few samples for an estimate
};
std::string_view describe(PictureKnown);

struct RenderResult {
    Film film;
    ErrorEstimate error;
    RenderCounters counters;
    StageTimes stage_times;  ///< summed over threads
    StopReason stopped_by = StopReason::samples;
    int spp_done = 0;  ///< samples that every pixel has
    double seconds = 0;
    int threads = 0;
    MemoryEstimate memory;
    PictureKnown known_of() const;
};

/// Throws Error: usage (tile size), memory (before anything large is allocated).
RenderResult render(const RenderPlan&, const RenderOptions&, const RenderEvents& = {});

}  // namespace drt
