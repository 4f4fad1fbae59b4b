#include "drt/stages/stages.h"

namespace drt {

template <class Real>
void splat_stage(StageContext<Real>& c) {
    const RayBatch<Real>& b = *c.batch;
    for (int slot = 0; slot < b.slots; ++slot) {
        const int i = b.pixel[slot];
        if (i >= c.pixels->count) continue;  // padding
        add_sample(*c.film, b.sample[slot], c.pixels->x[size_t(i)], c.pixels->y[size_t(i)],
                   {b.radiance.x[slot], b.radiance.y[slot], b.radiance.z[slot], b.alpha[slot]}, c.counters->film);
    }
}

template void splat_stage(StageContext<float>&);
template void splat_stage(StageContext<double>&);

template <class Real>
void end_stage(StageContext<Real>& c) {
    c.batch->count = 0;
}

template void end_stage(StageContext<float>&);
template void end_stage(StageContext<double>&);

}  // namespace drt
