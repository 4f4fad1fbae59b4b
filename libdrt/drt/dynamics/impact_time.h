#pragma once
// When two bodies in free flight touch: conservative advancement (Mirtich 1996). At each step the bodies fly for as
// long as they certainly stay apart: along the direction between their nearest points the gap closes by no more than
// their relative speed and acceleration, and the rims of their turning bodies, allow.

#include <optional>

#include "drt/dynamics/contact_world.h"
#include "drt/dynamics/path.h"

namespace drt {

/// When the two touch and approach, in [begin, end]. A pair that touches and parts is followed until it is apart.
std::optional<double> impact_time(const ContactWorld&, const RigidScene&, int a, const Path&, int b, const Path&,
                                  double begin, double end);

}  // namespace drt
