#include <gtest/gtest.h>

#include "apps/exit_codes.h"

namespace drt {
namespace {

TEST(ExitCodes, AreTheDocumentedNumbers) {
    EXPECT_EQ(exit_ok, 0);
    EXPECT_EQ(exit_code(ErrorKind::internal), 1);
    EXPECT_EQ(exit_code(ErrorKind::memory), 1);
    EXPECT_EQ(exit_code(ErrorKind::usage), 2);
    EXPECT_EQ(exit_code(ErrorKind::scene), 3);
    EXPECT_EQ(exit_code(ErrorKind::asset), 4);
    EXPECT_EQ(exit_code(ErrorKind::output), 5);
}

}  // namespace
}  // namespace drt
