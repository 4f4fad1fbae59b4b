#include "drt/base/version.h"

namespace drt {

const char* version() { return DRT_VERSION; }

const char* build_isa() {
#if defined(__AVX512F__)
    return "avx512";
#elif defined(__AVX2__)
    return "avx2";
#elif defined(__SSE4_2__)
    return "sse4.2";
#else
    return "sse2";
#endif
}

}  // namespace drt
