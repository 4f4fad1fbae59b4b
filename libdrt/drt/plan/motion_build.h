#pragma once
// Keyframes over scene time -> the path over one exposure, exact to the keyframes' interpolation.

#include <vector>

#include "drt/geometry/motion_path.h"
#include "drt/scene/scene_desc.h"

namespace drt {

/// Pieces over ray time u in [0, 1], where scene time goes linearly from time0 to time1 (either may be the larger).
/// A body that does not move in between gets one constant piece.
std::vector<MotionPiece<double>> build_path(const Motion&, double time0, double time1);

/// Nothing changes along the path.
bool is_constant(const std::vector<MotionPiece<double>>&);

}  // namespace drt
