#pragma once
// drt's picture of a case against the reference renderer's.

#include <gtest/gtest.h>

#include "drt/plan/plan.h"
#include "pictures/scenes.h"

namespace drt {

/// Fails where the two pictures differ by more than their noise explains (once in 1e4 for equal ones; the seeds are
/// fixed, so a pass stays one).
void expect_same_as_reference(const PictureCase&, const PlanOptions&, int reference_spp, int render_spp);

/// How GoogleTest shows a case.
void PrintTo(const PictureCase&, std::ostream*);

/// The case's name as GoogleTest wants it: letters, digits and underscores.
std::string test_name(const ::testing::TestParamInfo<PictureCase>&);

}  // namespace drt
