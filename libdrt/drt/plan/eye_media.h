#pragma once
// The media that the eye may be inside of: those are found for every camera sample, all others never.

#include "drt/plan/prepare.h"

namespace drt {

/// The refracting solids (and half-spaces behind planes) whose bounds over the exposure meet those of the lens.
std::vector<int> find_eye_media(const PreparedScene&);

}  // namespace drt
