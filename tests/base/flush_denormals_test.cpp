#include "drt/base/flush_denormals.h"

#include <gtest/gtest.h>

#include <limits>

namespace drt {
namespace {

TEST(FlushDenormals, HoldsAsLongAsItLives) {
    volatile float smallest = std::numeric_limits<float>::min();
    volatile float half = smallest * 0.5f;
    EXPECT_GT(half, 0.0f);
#if defined(__SSE2__)
    {
        const FlushDenormals outer;
        {
            const FlushDenormals inner;
            half = smallest * 0.5f;
            EXPECT_EQ(half, 0.0f);
        }
        half = smallest * 0.5f;
        EXPECT_EQ(half, 0.0f);
    }
#endif
    half = smallest * 0.5f;
    EXPECT_GT(half, 0.0f);
}

}  // namespace
}  // namespace drt
