#pragma once
// Which features a scene needs, and why the others are left out.

#include "drt/plan/features.h"
#include "drt/plan/prepare.h"

namespace drt {

/// The largest share of the light that a material sends on, by reflection and refraction.
double largest_share(const SceneDesc&);

/// A black background is none.
bool shows_background(const SceneDesc&);

Features find_features(const SceneDesc&, const PreparedScene&);

/// Samples of a pixel differ: the scene's features draw random numbers.
bool draws_samples(const Features&, const PreparedScene&);

/// --plan=general: every stage and every table, as if the scene used everything.
Features keep_everything(Features);

Explanation explain(const SceneDesc&, const PreparedScene&, const Features&, const std::string& double_reason);

}  // namespace drt
