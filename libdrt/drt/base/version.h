#pragma once

namespace drt {
const char* version();    ///< "0.1.0"
const char* build_isa();  ///< the widest instruction set this build uses: "avx512", "avx2", "sse4.2", "sse2"
}  // namespace drt
