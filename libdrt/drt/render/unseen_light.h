#pragma once

#include "drt/plan/sights.h"
#include "drt/stages/stage.h"

namespace drt {

/// So many samples tell how often a source is met.
inline constexpr std::uint64_t enough_hits = 16;

/// The brightest that a further sample might meet although the samples so far tell little of it: the sources that they
/// met less than enough_hits times, directly or by reflection and refraction, unless they are so large that `spp`
/// samples per pixel would have met them in the camera's view; and what glows.
double unseen_brightness(const Sights&, const SourceHits&, int spp);

}  // namespace drt
