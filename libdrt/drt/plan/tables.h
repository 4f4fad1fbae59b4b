#pragma once
// Materials, textures, the pixel filter and the sample plan of a frame.

#include <algorithm>
#include <vector>

#include "drt/plan/features.h"
#include "drt/plan/plan.h"
#include "drt/plan/prepare.h"
#include "drt/plan/world.h"

namespace drt {

struct SceneTables {
    MaterialTable materials;
    SharedTextures textures;
    FilterTable filter;
};

/// Gets the textures that some material uses. A missing one is an Error (asset) naming its place in the scene, or, on
/// request, a checker and a note.
SceneTables build_tables(const SceneDesc&, const PlanOptions&, const Features&, TextureCache&, Diagnostics& notes);

template <class Real>
SamplePlan plan_samples(const SceneDesc& scene, const PlanOptions& options, const Features& f, const World<Real>& w) {
    SamplePlan s;
    s.seed = scene.render.seed;
    s.frame = std::uint32_t(options.frame);
    s.kind = options.sampler;
    s.max_depth = f.scatter ? scene.render.max_depth : 0;
    // No path can be inside more bodies than there are refracting ones.
    const auto refracting = int(
        std::count_if(w.bodies.roles.begin(), w.bodies.roles.end(), [](const ContactRole& r) { return r.refracts; }));
    s.media_capacity = f.refraction ? std::clamp(refracting, 1, most_media) : 0;
    s.roulette_depth = 3;
    s.roulette_threshold = 0.05f;
    return s;
}

template <class Real>
std::size_t world_memory(const World<Real>& w) {
    const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    const BodyTable<Real>& b = w.bodies;
    std::size_t sum = bytes(b.centers) + bytes(b.roles) + bytes(b.surface_error) + bytes(b.motions) + bytes(b.pieces) +
                      bytes(b.spheres) + bytes(b.flats) + bytes(b.boxes) + bytes(b.cylinders) + bytes(b.planes) +
                      bytes(w.body_material) + bytes(w.body_emitter) + bytes(w.body_mapping) + bytes(w.mappings) +
                      w.accel->memory() + bytes(w.lights.points) + bytes(w.lights.rects) + bytes(w.lights.spheres) +
                      bytes(w.lights.tree.nodes);
    for (const auto& t : w.textures.maps) sum += bytes(t->texels);
    return sum;
}

}  // namespace drt
