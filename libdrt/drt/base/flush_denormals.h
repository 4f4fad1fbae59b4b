#pragma once
// Numbers below the range of normal floats count as zero while an object of this type lives, on its thread. A
// highlight's tail ends in such numbers, and each operation on one costs the processor some 150 cycles; Embree, too,
// asks for it.

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace drt {

class FlushDenormals {
public:
#if defined(__SSE2__)
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON); }
    ~FlushDenormals() { _mm_setcsr(before_); }
#else
    FlushDenormals() = default;
    ~FlushDenormals() = default;
#endif
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
#if defined(__SSE2__)
    unsigned before_;
#endif
};

}  // namespace drt
