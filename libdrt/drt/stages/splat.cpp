#include <algorithm>

#include "drt/stages/stages.h"

namespace drt {

template <class Real>
void splat_stage(StageContext<Real>& c) {
    const RayBatch<Real>& b = *c.batch;
    const int pixels = c.pixels.count();
    for (int s = 0; s < std::min(replicate_count, c.samples); ++s) {
        BlockSamples samples;
        samples.stride = replicate_count * pixels;
        samples.count = (c.samples - s + replicate_count - 1) / replicate_count;
        int slot = s * pixels;
        for (const TileBlock& block : c.pixels.blocks) {
            samples.rgba = {b.radiance.x.at(slot), b.radiance.y.at(slot), b.radiance.z.at(slot), b.alpha.at(slot)};
            add_block(*c.film, c.first_sample + std::uint32_t(s), block.x, block.y, samples, c.counters->film);
            slot += block_pixels;
        }
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
