#pragma once
// The order of bodies where they overlap or touch: the lowest rank owns the place.

#include "drt/plan/prepare.h"

namespace drt {

/// Sets every body's ContactRole. First come bodies of higher `priority`, then solids before flat pieces before planes,
/// then the smaller ones (by volume; flat pieces by area), then the later ones of the scene.
void assign_roles(PreparedScene&, const SceneDesc&);

/// Throws Error (scene), naming the body, where more bodies that refract are inside each other than a path can
/// remember.
void check_nesting(const PreparedScene&, const SceneDesc&);

}  // namespace drt
