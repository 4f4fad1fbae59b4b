#include "support/render_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/compare.h"

namespace drt {

RenderResult render_scene(const SceneDesc& scene, const PlanOptions& plan, const RenderOptions& options) {
    return render(compile(scene, plan), options);
}

PictureEstimate estimate_scene(const SceneDesc& scene, const PlanOptions& plan, int spp, int seeds) {
    if (spp % 2 != 0) throw std::invalid_argument("replicates of equal weight need an even number of samples");
    const RenderPlan compiled = compile(scene, plan);  // once: it reads the textures and builds the trees
    RenderOptions options;
    options.spp = spp;
    std::vector<Image> replicates;
    for (int i = 0; i < seeds; ++i) {
        std::visit([&](const auto& world) { world->sampling.seed = scene.render.seed + std::uint32_t(i); },
                   compiled.world);
        const RenderResult result = render(compiled, options);
        for (const int replicate : {0, 1}) replicates.push_back(resolve(result.film, replicate));
    }
    return estimate_from_replicates(replicates);
}

bool same_bits(const Film& a, const Film& b) {
    return a.width == b.width && a.height == b.height && a.blocks == b.blocks;
}

double largest_difference(const Image& a, const Image& b) {
    if (a.data.size() != b.data.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (size_t i = 0; i < a.data.size(); ++i) {
        const double difference = std::abs(double(a.data[i]) - double(b.data[i]));
        if (!(difference <= largest))
            largest = std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
    }
    return largest;
}

}  // namespace drt
