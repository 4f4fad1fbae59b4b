#pragma once
// A planted fault as a test: the comparison sees it, and nothing where there is none.

#include <gtest/gtest.h>

#include "regression/faults.h"

namespace drt {

void expect_seen(const PlantedFault&);

/// How GoogleTest shows a fault.
void PrintTo(const PlantedFault&, std::ostream*);

/// The fault's name as GoogleTest wants it: letters, digits and underscores.
std::string test_name(const ::testing::TestParamInfo<PlantedFault>&);

}  // namespace drt
