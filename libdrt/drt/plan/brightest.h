#pragma once

#include "drt/plan/prepare.h"

namespace drt {

/// The largest value of a channel that a camera ray may bring back by meeting something that shines by itself: a
/// visible light, the background, a surface's ambient term; however materials brighten it on the way. Not what surfaces
/// reflect of lights that are sampled.
float brightest_sight(const SceneDesc&, const PreparedScene&);

/// Some material sends on more light than it receives, so that paths get ever brighter.
bool brightens(const SceneDesc&);

}  // namespace drt
