#include "regression/error_study.h"

#include <algorithm>
#include <cmath>

#include "drt/bake/bake.h"
#include "drt/formats/formats.h"
#include "regression/regression.h"
#include "support/render_picture.h"

namespace drt {

namespace {

double rmse_between(const Image& picture, const std::vector<double>& truth) {
    double squares = 0;
    for (size_t i = 0; i < truth.size(); ++i)
        if (i % 4 != 3) squares += std::pow(double(picture.data[i]) - truth[i], 2);
    return std::sqrt(squares / (0.75 * double(truth.size())));
}

}  // namespace

std::vector<StudyScene> shipped_scenes_to_study() {
    std::vector<StudyScene> scenes;
    for (const Shot& shot : shots()) scenes.push_back({shot.name, bake(read_shot(shot), 0).scene, shot.frame});
    return scenes;
}

std::vector<StudyScene> fireflies_to_study() {
    std::vector<StudyScene> scenes;
    for (const std::string name : {"tiny-lamp", "glossy-floor", "glossy-glass", "specks", "faint-glass"})
        scenes.push_back({name, read_scene(repository() + "/tests/regression/fireflies/" + name + ".yaml").scene, 0});
    return scenes;
}

std::vector<ErrorTrial> study_errors(const StudyScene& study, const StudyOptions& o) {
    SceneDesc scene = study.scene;
    scene.render.width = o.width;
    scene.render.height = o.height;
    PlanOptions plan_options;
    plan_options.frame = study.frame;
    const RenderPlan plan = compile(scene, plan_options);
    std::vector<ErrorTrial> trials;
    std::vector<Image> pictures;
    std::vector<double> truth(size_t(o.width) * size_t(o.height) * 4);
    for (int seed = 0; seed < o.seeds; ++seed) {
        std::visit([&](const auto& world) { world->sampling.seed = std::uint32_t(seed); }, plan.world);
        for (int spp = 2; spp <= o.most_spp; spp *= 2) {
            RenderOptions options;
            options.spp = spp;
            const RenderResult result = render(plan, options);
            trials.push_back({spp, result.error, 0});
            pictures.push_back(resolve(result.film));
        }
        for (size_t i = 0; i < truth.size(); ++i) truth[i] += double(pictures.back().data[i]) / o.seeds;
    }
    for (size_t i = 0; i < trials.size(); ++i) trials[i].rmse = rmse_between(pictures[i], truth);
    return trials;
}

}  // namespace drt
