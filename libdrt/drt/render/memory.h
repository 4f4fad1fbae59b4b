#pragma once

#include "drt/plan/plan.h"

namespace drt {

/// Bytes that rendering a plan takes at its peak, known before anything is allocated: within 10 %
/// (tests/render/memory_test.cpp).
struct MemoryEstimate {
    std::size_t scene = 0;    ///< held by the plan already
    std::size_t film = 0;     ///< sums, and the list of tiles
    std::size_t picture = 0;  ///< as resolved from the film
    std::size_t batches = 0;  ///< of all threads
    std::size_t to_allocate() const { return film + picture + batches; }
    std::size_t total() const { return scene + to_allocate(); }
};

MemoryEstimate estimate_memory(const RenderPlan&, int threads);

/// Throws Error (memory) if more has to be allocated than `available` bytes.
void check_memory(const RenderPlan&, const MemoryEstimate&, std::size_t available);

}  // namespace drt
