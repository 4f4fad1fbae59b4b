#pragma once
// The command line of drt-render.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drt/formats/formats.h"
#include "drt/image/image.h"
#include "drt/plan/plan.h"

namespace drt {

enum class ProgressStyle { automatic, bar, plain, none };

struct Snapshot {
    std::string path;
    double interval = 0;  ///< seconds; 0 = after every pass
};

/// What overrides the scene file; empty = as the scene says.
struct Overrides {
    std::optional<int> spp, max_depth, width, height;
    std::optional<std::uint32_t> seed;
};

struct RenderArguments {
    std::string scene;
    std::vector<std::string> outputs;  ///< may hold a frame token: #### or %04d
    std::vector<int> frames{0};
    Overrides overrides;
    double time_limit = 0;  ///< seconds per frame
    int threads = 0;
    std::optional<Snapshot> snapshot;
    bool preview = false;  ///< legacy -p: no distributed effects
    bool explain = false, check = false;
    bool quiet = false, verbose = false;
    std::string bake_cache;  ///< folder for motion computed from physics; "" = none
    ProgressStyle progress = ProgressStyle::automatic;
    DisplayTransform display;
    PlanOptions plan;
    LegacyOptions legacy;
};

/// Parses the command line. Returns nothing when all is said and done (--help, --version); throws Error (usage) on
/// anything wrong.
std::optional<RenderArguments> parse_arguments(int argc, char** argv);

}  // namespace drt
