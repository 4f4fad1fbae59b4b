#include <fmt/format.h>

#include <algorithm>

#include "drt/plan/explain.h"
#include "drt/plan/plan.h"
#include "drt/plan/prepare.h"
#include "drt/plan/tables.h"
#include "drt/plan/texture_cache.h"

namespace drt {

namespace {

template <class Real>
Mapping<Real> cast(const Mapping<double>& m) {
    return {m.kind, Vec3<Real>(m.ax), Vec3<Real>(m.ay), Vec3<Real>(m.az), Vec3<Real>(m.origin)};
}

// Lists in the order of the body table, whose bodies are sorted.
std::vector<int> in_order(const std::vector<int>& values, const std::vector<int>& order) {
    std::vector<int> out(order.size());
    std::transform(order.begin(), order.end(), out.begin(), [&](int source) { return values[size_t(source)]; });
    return out;
}

template <class Real>
ShapeRef shape_of(const BodyTable<Real>& t, int body) {
    for (const BodyGroup& g : t.groups)
        if (body >= g.first && body < g.first + g.count) return {g.kind, body, g.first_shape + body - g.first};
    return {ShapeKind::plane, body, t.plane_group.first_shape + body - t.plane_group.first};
}

template <class Real>
std::unique_ptr<World<Real>> build_world(const SceneDesc& scene, PreparedScene&& p, const PlanOptions& options,
                                         const Features& features, SceneTables&& tables) {
    auto w = std::make_unique<World<Real>>();
    w->features = features;
    w->origin = p.origin;
    BuiltTable<Real> built = build_body_table<Real>(p.bodies);
    p.bodies = {};  // the prepared bodies are large; a million of them need not live through the BVH build
    w->bodies = std::move(built.table);
    w->body_material = in_order(p.body_material, built.order);
    if (features.visible_lights) w->body_emitter = in_order(p.body_emitter, built.order);
    if (features.textures) {
        w->body_mapping = in_order(p.body_mapping, built.order);
        for (const Mapping<double>& m : p.mappings) w->mappings.push_back(cast<Real>(m));
    }
    std::vector<int> new_id(built.order.size());
    for (size_t id = 0; id < built.order.size(); ++id) new_id[size_t(built.order[id])] = int(id);
    w->lights = cast<Real>(std::move(p.lights));
    const auto renumber = [&](auto& lights) {
        for (auto& l : lights)
            if (l.body >= 0) l.body = new_id[size_t(l.body)];
    };
    for (const int i : p.eye_media) w->eye_media.push_back(shape_of(w->bodies, new_id[size_t(i)]));
    renumber(w->lights.points);
    renumber(w->lights.rects);
    renumber(w->lights.spheres);
    w->emitters = std::move(p.emitters);
    w->materials = std::move(tables.materials);
    w->textures = std::move(tables.textures);
    w->camera = cast<Real>(p.camera);
    w->view = cast<Real>(view_at(p.camera, 0.0));
    w->filter = tables.filter;
    w->background = scene.background;
    if (shows_background(scene)) w->backdrop = {scene.background, 1};
    w->sampling = plan_samples(scene, options, features, *w);
    w->accel = std::make_unique<Accel<Real>>(w->bodies);
    return w;
}

bool use_double(const PlanOptions& options, const std::string& reason) {
    switch (options.precision) {
        case PlanOptions::Precision::single:
            return false;
        case PlanOptions::Precision::double_:
            return true;
        case PlanOptions::Precision::automatic:
            break;
    }
    return !reason.empty();
}

}  // namespace

RenderPlan compile(const SceneDesc& scene, const PlanOptions& options) {
    TextureCache textures;
    return compile(scene, options, textures);
}

RenderPlan compile(const SceneDesc& scene, const PlanOptions& options, TextureCache& textures) {
    RenderPlan plan;
    plan.width = scene.render.width;
    plan.height = scene.render.height;
    PreparedScene prepared = prepare(scene, options);
    plan.exposure = prepared.exposure;
    const std::string reason = needs_double(prepared);
    plan.features = find_features(scene, prepared);
    plan.random = draws_samples(plan.features, prepared);
    plan.features.double_precision = use_double(options, reason);
    if (options.general) plan.features = keep_everything(plan.features);
    plan.sights = find_sights(scene, prepared);
    plan.explanation = explain(scene, prepared, plan.features, reason);
    SceneTables tables = build_tables(scene, options, plan.features, textures, plan.notes);
    if (plan.features.double_precision)
        plan.world = build_world<double>(scene, std::move(prepared), options, plan.features, std::move(tables));
    else
        plan.world = build_world<float>(scene, std::move(prepared), options, plan.features, std::move(tables));
    plan.memory = std::visit([](const auto& w) { return world_memory(*w); }, plan.world);
    return plan;
}

}  // namespace drt
