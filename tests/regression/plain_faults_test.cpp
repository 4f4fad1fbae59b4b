// What the comparison of every run must see.

#include "regression/planted_fault_test.h"

namespace drt {
namespace {

class PlainFaults : public ::testing::TestWithParam<PlantedFault> {};

TEST_P(PlainFaults, AreSeen) { expect_seen(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Shots, PlainFaults, ::testing::ValuesIn(plain_faults()), test_name);

}  // namespace
}  // namespace drt
