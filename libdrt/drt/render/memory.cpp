#include "drt/render/memory.h"

#include <fmt/format.h>

#include "drt/base/diagnostic.h"
#include "drt/film/film.h"
#include "drt/stages/stage.h"

namespace drt {

MemoryEstimate estimate_memory(const RenderPlan& plan, int threads) {
    MemoryEstimate m;
    const std::size_t pixels = std::size_t(plan.width) * std::size_t(plan.height);
    m.scene = plan.memory;
    m.film = film_memory(plan.width, plan.height) + pixels / block_pixels * sizeof(TileBlock);
    m.picture = pixels * 4 * sizeof(float);
    const std::size_t batch = std::visit(
        [](const auto& world) {
            using Real = typename std::decay_t<decltype(*world)>::RealType;
            const auto media = std::size_t(world->sampling.media_capacity);
            return sizeof(RayBatch<Real>) + (media > 0 ? media + 1 : 0) * batch_capacity * sizeof(std::int32_t);
        },
        plan.world);
    m.batches = std::size_t(threads) * batch;
    return m;
}

void check_memory(const RenderPlan& plan, const MemoryEstimate& m, std::size_t available) {
    if (m.to_allocate() <= available) return;
    throw Error(ErrorKind::memory,
                fmt::format("a picture of {} x {} pixels takes {:.1f} GB of memory to render, "
                            "{:.1f} GB are available",
                            plan.width, plan.height, double(m.to_allocate()) * 1e-9, double(available) * 1e-9));
}

}  // namespace drt
