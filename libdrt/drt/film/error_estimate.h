#pragma once
// How wrong a picture is, from its two replicates: docs/sampling.md.

#include "drt/film/film.h"

namespace drt {

struct ErrorEstimate {
    double rmse = 0;        ///< root mean square error of the picture's RGB values
    double relative = 0;    ///< rmse / root mean square of the picture's RGB values
    double freedom = 0;     ///< degrees of freedom that it rests on
    bool valid = false;     ///< false until every pixel has a sample in both replicates
    bool at_least = false;  ///< the error may be larger: light that few samples meet, or none yet, decides it
};

/// What the scene is known to hold.
struct SceneLimits {
    double brightest = 0;  ///< the largest value that a sample may have without having been seen often already
    bool random = true;    ///< false: all samples of a pixel are the same ray, and no difference means no error
};

/// Sharp (a few percent) over 1e4 and more pixels, unless it is "at least".
ErrorEstimate estimate_error(const Film&, const SceneLimits& = {});

}  // namespace drt
