#include <limits>

#include "drt/stages/stages.h"

namespace drt {

template <class Real>
void intersect_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += P::width) {
        RayPacket<Real> rays;
        rays.o = load3<R>(b.o, i);
        rays.d = load3<R>(b.d, i);
        rays.tmax = R(std::numeric_limits<Real>::infinity());
        rays.time = load<F>(b.time.at(i));
        rays.start = load<I>(b.start.at(i));
        rays.active = mask_cast<F>(load<I>(b.slot.at(i)) >= I(0));
        HitPacket<Real> hits;
        c.world->accel->intersect(rays, hits, c.counters->trace);
        store(hits.t, b.t.at(i));
        store3(hits.ng, b.ng, i);
        store(select(mask_cast<I>(rays.active), hits.body, I(no_body)), b.body.at(i));
        store(hits.part, b.part.at(i));
    }
}

template void intersect_stage(StageContext<float>&);
template void intersect_stage(StageContext<double>&);

}  // namespace drt
