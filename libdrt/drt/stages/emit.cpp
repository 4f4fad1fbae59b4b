#include "drt/light/light_choice.h"
#include "drt/light/light_sample.h"
#include "drt/stages/accumulate.h"
#include "drt/stages/glossy_lights.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

// How much of a light that the ray meets counts: the rest is what the samples of the light found at the hit before.
template <class Real>
float lobe_weight(const World<Real>& w, const RayBatch<Real>& b, int ray, LightId light) {
    const float density = b.lobe.density[ray];
    if (density <= 0 || light == no_light) return 1;
    const Vec3<Real> wi{b.d.x[ray], b.d.y[ray], b.d.z[ray]};
    const Real passed = Real(b.lobe.passed[ray]), distance = passed + b.t[ray];
    const Vec3<Real> p = Vec3<Real>{b.o.x[ray], b.o.y[ray], b.o.z[ray]} - wi * passed;
    const Vec3f n{b.lobe.n.x[ray], b.lobe.n.y[ray], b.lobe.n.z[ray]};
    const float pdf = visit_light(w.lights, light, [&](const auto& l) { return light_pdf(l, p, wi, distance); });
    return power_heuristic(density, pdf * samples_of(w.lights, light, p, n));
}

// Visible lights in the packet: what they send back along the rays that hit them. They are rare, so lane by lane.
template <class Real>
Color3<typename Pack<Real>::F> emitted(const World<Real>& w, const RayBatch<Real>& b, int i, SourceHits& hits) {
    using F = typename Pack<Real>::F;
    Color3<F> out(F(0));
    for (int l = 0; l < Pack<Real>::width; ++l) {
        const int body = b.body[i + l];
        if (body < 0 || w.body_emitter[size_t(body)] < 0) continue;
        const Emitter& e = w.emitters[size_t(w.body_emitter[size_t(body)])];
        if (!e.two_sided && !b.outward[i + l]) continue;
        ++(b.bounce == 0 ? hits.direct : hits.scattered)[SourceHits::bin(max_component(e.radiance))];
        const float weight = w.features.lobe_lights && b.bounce > 0 ? lobe_weight(w, b, i + l, e.light) : 1.0f;
        out.r[l] = e.radiance.r * weight;
        out.g[l] = e.radiance.g * weight;
        out.b[l] = e.radiance.b * weight;
    }
    return out;
}

}  // namespace

template <class Real>
void emit_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using F = typename P::F;
    using I = typename P::I;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    const Color3<F> background(b.bounce == 0 ? w.backdrop.color : w.background);
    for (int i = 0; i < b.count; i += P::width) {
        const auto live = mask_cast<F>(load<I>(b.slot.at(i)) >= I(0));
        const auto hit = live && mask_cast<F>(load<I>(b.body.at(i)) >= I(0));
        const I material = load<I>(b.material.at(i));
        const auto shaded = mask_cast<F>(material >= I(0));
        const I safe = max(material, I(0));
        Color3<F> ambient = gather_color<F>(w.materials.ambient, safe);
        if (w.features.textures) {
            const auto textured = mask_cast<F>(gather_coherent<I>(w.materials.texture.data(), safe) >= I(0));
            ambient = select(textured, load_color<F>(b.albedo, i) * Color3<F>(w.materials.ambient_light), ambient);
        }
        Color3<F> light = select(hit, Color3<F>(F(0)), background);
        light = select(shaded, ambient, light);
        if (w.features.visible_lights) light += emitted(w, b, i, c.counters->sources);
        const Color3<F> throughput = load_color<F>(b.throughput, i);
        if (b.bounce > 0) {
            add_radiance(b, i, live, throughput * light);
            continue;
        }
        // A path's first light starts its sum. Coverage: the filter's weight goes with it, so that its mean is the
        // filtered coverage.
        store_color(select(live, throughput * light, Color3<F>(F(0))), b.radiance, i);
        store(select(live, throughput.r * select(hit, F(1), F(w.backdrop.alpha)), F(0)), b.alpha.at(i));
        c.counters->camera_hits += std::uint64_t(count(hit));
    }
}

template void emit_stage(StageContext<float>&);
template void emit_stage(StageContext<double>&);

}  // namespace drt
