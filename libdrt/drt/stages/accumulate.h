#pragma once
// Adding light to the paths of a packet.

#include "drt/stages/ray_batch.h"

namespace drt {

namespace detail {
template <class F, class I, class Mask>
[[gnu::always_inline]] inline void add_column(Column<float>& column, int i, bool contiguous, const I& slot,
                                              const Mask& m, const F& v) {
    if (contiguous) {
        float* p = column.at(i);
        store(load<F>(p) + select(m, v, F(0)), p);
    } else {
        const I safe = max(slot, I(0));
        scatter(m, F(gather<F>(column.at(0), safe) + v), column.at(0), safe);
    }
}
}  // namespace detail

/// Adds light to the paths of packet i, in the lanes of the mask. Before the first compaction slot and ray number
/// agree.
template <class Real>
[[gnu::always_inline]] inline void add_radiance(RayBatch<Real>& b, int i, const typename Pack<Real>::Mask& m,
                                                const Color3<typename Pack<Real>::F>& light) {
    using I = typename Pack<Real>::I;
    const I slot = load<I>(b.slot.at(i));
    const bool contiguous = b.bounce == 0;
    detail::add_column(b.radiance.x, i, contiguous, slot, m, light.r);
    detail::add_column(b.radiance.y, i, contiguous, slot, m, light.g);
    detail::add_column(b.radiance.z, i, contiguous, slot, m, light.b);
}

}  // namespace drt
