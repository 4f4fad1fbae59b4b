#pragma once
// Which lights a hit asks. Up to `few_lights` of a sort, with falloff or without, every hit asks each; of more, four
// chosen ones: by the light tree those with falloff, by their power the others, which are as strong everywhere.

#include "drt/light/light_table.h"

namespace drt {

inline constexpr int few_lights = 16;
inline constexpr int plain_draws = 4;  ///< of lights without falloff, stratified

/// Fills asked, tree and plain.
void plan_light_choice(LightTable<double>&);

/// How many samples a hit at p with the unit normal n takes of a light with falloff, in the mean.
template <class Real>
float samples_of(const LightTable<Real>& t, LightId light, const Vec3<Real>& p, const Vec3f& n) {
    return t.tree.empty() ? 1 : float(tree_draws) * choice_probability(t.tree, light, p, n);
}

}  // namespace drt
