#include "drt/stages/stages.h"

namespace drt {

std::string_view name_of(StageKind k) {
    switch (k) {
        case StageKind::generate:
            return "generate";
        case StageKind::intersect:
            return "intersect";
        case StageKind::surface:
            return "surface";
        case StageKind::emit:
            return "emit";
        case StageKind::light:
            return "light";
        case StageKind::scatter:
            return "scatter";
        case StageKind::splat:
            return "splat";
    }
    return "";
}

void merge(RenderCounters& into, const RenderCounters& from) {
    into.camera_rays += from.camera_rays;
    into.scattered_rays += from.scattered_rays;
    into.shadow_rays += from.shadow_rays;
    into.camera_hits += from.camera_hits;
    into.cut_paths += from.cut_paths;
    into.media_overflows += from.media_overflows;
    into.trace.rejected += from.trace.rejected;
    for (size_t i = 0; i < into.sources.direct.size(); ++i) {
        into.sources.direct[i] += from.sources.direct[i];
        into.sources.scattered[i] += from.sources.scattered[i];
    }
    merge(into.film, from.film);
}

void merge(StageTimes& into, const StageTimes& from) {
    for (size_t i = 0; i < into.spent.size(); ++i) into.spent[i] += from.spent[i];
}

template <class Real>
void run(const Pipeline<Real>& pipeline, StageContext<Real>& c, StageTimes& times) {
    auto begin = std::chrono::steady_clock::now();
    const auto run_all = [&](const std::vector<Stage<Real>>& stages) {
        for (const Stage<Real>& stage : stages) {
            stage.run(c);
            const auto end = std::chrono::steady_clock::now();
            times.spent[size_t(stage.kind)] += end - begin;
            begin = end;
        }
    };
    run_all(pipeline.first);
    while (c.batch->count > 0) run_all(pipeline.bounce);
    run_all(pipeline.last);
}

template void run(const Pipeline<float>&, StageContext<float>&, StageTimes&);
template void run(const Pipeline<double>&, StageContext<double>&, StageTimes&);

template <class Real>
Pipeline<Real> compose(const Features& f) {
    Pipeline<Real> p;
    p.first.push_back({StageKind::generate, generate_stage<Real>});
    if (f.eye_media) p.first.push_back({StageKind::generate, eye_media_stage<Real>});
    p.bounce.push_back({StageKind::intersect, intersect_stage<Real>});
    p.bounce.push_back({StageKind::surface, surface_stage<Real>});
    p.bounce.push_back({StageKind::emit, emit_stage<Real>});
    if (f.lights) p.bounce.push_back({StageKind::light, light_stage<Real>});
    p.bounce.push_back({StageKind::scatter, f.scatter ? scatter_stage<Real> : end_stage<Real>});
    p.last.push_back({StageKind::splat, splat_stage<Real>});
    return p;
}

template Pipeline<float> compose(const Features&);
template Pipeline<double> compose(const Features&);

}  // namespace drt
