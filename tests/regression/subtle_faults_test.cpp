// What the comparison must see with more samples, and that it sees the lights of every shot.

#include "regression/planted_fault_test.h"

namespace drt {
namespace {

class SubtleFaults : public ::testing::TestWithParam<PlantedFault> {};

TEST_P(SubtleFaults, AreSeen) { expect_seen(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Shots, SubtleFaults, ::testing::ValuesIn(subtle_faults()), test_name);

}  // namespace
}  // namespace drt
