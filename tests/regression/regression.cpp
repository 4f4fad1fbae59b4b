#include "regression/regression.h"

#include <stdexcept>

#include "drt/bake/bake.h"
#include "drt/formats/formats.h"
#include "support/render_picture.h"

namespace drt {

const std::vector<Shot>& shots() {
    static const std::vector<Shot> all{
        {"billiard", "scenes/billiard.yaml"},
        {"bounce", "scenes/bounce.yaml", 2},
        {"break", "scenes/break.yaml", 3},  // as long as its motion can be foretold
        {"camera-move", "scenes/camera-move.yaml", 20},
        {"camera-move-backwards", "scenes/camera-move.yaml", 50},
        {"combined-classic", "scenes/combined-classic.yaml"},
        {"combined-distributed", "scenes/combined-distributed.yaml"},
        {"dominoes", "scenes/dominoes.yaml", 2},
        {"focus-classic", "scenes/focus-classic.yaml"},
        {"focus-distributed", "scenes/focus-distributed.yaml"},
        {"glossy-classic", "scenes/glossy-classic.yaml"},
        {"glossy-distributed", "scenes/glossy-distributed.yaml"},
        {"heavy-on-light", "scenes/heavy-on-light.yaml", 13},
        {"motion-classic", "scenes/motion-classic.yaml"},
        {"motion-distributed", "scenes/motion-distributed.yaml"},
        {"room", "scenes/room.yaml"},
        {"shadows-classic", "scenes/shadows-classic.yaml"},
        {"shadows-distributed", "scenes/shadows-distributed.yaml"},
        {"textures", "scenes/textures.yaml"},
        {"translucency-classic", "scenes/translucency-classic.yaml"},
        {"translucency-distributed", "scenes/translucency-distributed.yaml"},
        {"turn", "scenes/turn.yaml", 8},
        {"lobes", "tests/regression/lobes.yaml"},
        {"legacy-carousel", "scenes/legacy/carousel.txt", 10},
        {"legacy-manual-example", "scenes/legacy/manual-example.txt", 4},
        {"legacy-manual-example-lit", "scenes/legacy/manual-example-lit.txt", 4},
        {"legacy-still-life", "scenes/legacy/still-life.txt"},
    };
    return all;
}

const Shot& find_shot(const std::string& name) {
    for (const Shot& shot : shots())
        if (shot.name == name) return shot;
    throw std::invalid_argument("no reference is called " + name);
}

std::string repository() { return DRT_SOURCE_DIR; }

std::string reference_path(const Shot& shot) {
    return repository() + "/tests/regression/references/" + shot.name + ".exr";
}

SceneDesc read_shot(const Shot& shot) {
    SceneDesc scene = read_scene(repository() + "/" + shot.file).scene;
    scene.render.width = reference_width;
    scene.render.height = reference_height;
    return scene;
}

PictureEstimate render_shot(const Shot& shot, SceneDesc scene, int seeds, std::uint32_t first_seed) {
    scene.render.seed = first_seed;
    scene = bake(scene, 0).scene;  // the same if it is without physics
    PlanOptions plan;
    plan.frame = shot.frame;
    return estimate_scene(scene, plan, spp_per_seed, seeds);
}

CompareResult compare_with_reference(const Shot& shot, const SceneDesc& scene, int seeds, std::uint32_t first_seed) {
    const ReferencePicture reference = read_reference(reference_path(shot));
    if (reference.spp != spp_per_seed) throw std::runtime_error("the reference has another number of samples a seed");
    const auto look = [&](int n, std::uint32_t seed) {
        CompareOptions options;
        options.alpha = false_alarms / double(shots().size());
        options.least_variance_ratio = double(reference.seeds) / n;
        return compare_pictures(render_shot(shot, scene, n, seed), reference.picture, options);
    };
    CompareResult result = look(seeds, first_seed);
    if (!result.same) result = look(2 * seeds, first_seed + std::uint32_t(seeds));
    return result;
}

}  // namespace drt
