#include "drt/light/light_sample.h"
#include "drt/material/phong.h"
#include "drt/stages/accumulate.h"
#include "drt/stages/stages.h"

namespace drt {

// Light by light (or choice by choice), each in three loops over the batch: draw the sample points, sample the light
// and shade, ask for visibility. What is done for one packet is a chain in which every step waits for the one before;
// in short loops the machine overlaps several packets, and across a query it overlaps none.

namespace {

// What a light sample needs of a packet of surface points.
template <class Real>
struct Shading {
    using P = Pack<Real>;
    Vec3<typename P::R> p, n;
    Vec3<typename P::F> nf, wo;
    PhongParameters<typename P::F> phong;
    typename P::Mask active;
    bool shiny = false;  // some lane has highlights
};

template <class Real>
[[gnu::always_inline]] inline Shading<Real> load_shading(const World<Real>& w, const RayBatch<Real>& b, int i) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const I material = load<I>(b.material.at(i));
    const I safe = max(material, I(0));
    Shading<Real> s;
    s.p = load3<R>(b.p, i);
    s.n = load3<R>(b.n, i);
    s.nf = Vec3<F>(s.n);
    s.wo = -Vec3<F>(load3<R>(b.d, i));
    s.phong.diffuse = load_color<F>(b.albedo, i);
    if (w.features.specular) {
        s.phong.specular = gather_color<F>(w.materials.specular, safe);
        s.phong.shininess = gather_coherent<F>(w.materials.shininess.data(), safe);
        s.shiny = any(max_component(s.phong.specular) > F(0));
    }
    s.active = mask_cast<F>(material >= I(0));
    return s;
}

// Phong's terms for one light sample; zero where the light is behind the surface.
template <class Real>
[[gnu::always_inline]] inline Color3<typename Pack<Real>::F> shade(const Shading<Real>& s,
                                                                   const Vec3<typename Pack<Real>::F>& wi) {
    using F = typename Pack<Real>::F;
    const F cosine = dot(s.nf, wi);
    Color3<F> f = phong_diffuse(s.phong, cosine);
    if (s.shiny) f += phong_specular(s.phong, s.nf, wi, s.wo, cosine);
    return f;
}

// A point of the unit square per surface point: into the first two columns of the shadow rays' directions.
template <class Real>
void sample_light_points(StageContext<Real>& c, DimId dimension) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using U = typename P::U;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += P::width) {
        const SlotSamples<F> samples{load<U>(b.key.at(i)), load<U>(b.hit_index.at(i))};
        const Vec2<F> u = sample_2d(c.world->sampling.kind, samples, dimension);
        store(num_cast<R>(u.x), b.shadow.d.x.at(i));
        store(num_cast<R>(u.y), b.shadow.d.y.at(i));
    }
}

// One sample of a light per surface point (each lane may have a light of its own): into the batch's shadow rays.
// False if the whole packet is unlit.
template <class Real, class Light>
[[gnu::always_inline]] inline bool sample_packet(ShadowRays<Real>& rays, int i, const Shading<Real>& s,
                                                 const Light& light, const typename Pack<Real>::F& weight) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    const LightSample<R> sample = sample_light(light, s.p, {load<R>(rays.d.x.at(i)), load<R>(rays.d.y.at(i))});
    const Color3<F> reflected = shade(s, Vec3<F>(sample.wi)) * sample.intensity * weight;
    // In front by the same normal, in the precision that decides which side the shadow ray leaves on.
    const auto in_front = mask_cast<F>(dot(s.n, sample.wi) > R(0));
    const auto lit = s.active && sample.lit && in_front && max_component(reflected) > F(0);
    store(select(lit, reflected.r, F(0)), rays.light.x.at(i));
    store(select(lit, reflected.g, F(0)), rays.light.y.at(i));
    store(select(lit, reflected.b, F(0)), rays.light.z.at(i));
    store3(sample.wi, rays.d, i);
    store(sample.distance, rays.distance.at(i));
    store(light.body, rays.exclude.at(i));
    return any(lit);
}

// Adds what the shadow rays carry where nothing is in their way.
template <class Real>
void trace_shadow_rays(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    constexpr Real almost = 1 - 8 * std::numeric_limits<Real>::epsilon();  // what the light touches does not hide it
    for (int i = 0; i < b.count; i += P::width) {
        const Color3<F> light = load_color<F>(b.shadow.light, i);
        const auto active = max_component(light) > F(0);
        if (!any(active)) continue;
        c.counters->shadow_rays += std::uint64_t(count(active));
        // A shadow ray leaves on the side that n points to: outward if that is ng's side.
        const I start = start::pack(load<I>(b.body.at(i)), load<I>(b.part.at(i)), load<I>(b.outward.at(i)));
        const RayPacket<Real> rays{load3<R>(b.p, i),
                                   load3<R>(b.shadow.d, i),
                                   load<R>(b.shadow.distance.at(i)) * R(almost),
                                   load<F>(b.time.at(i)),
                                   start,
                                   active};
        const auto blocked = c.world->accel->occluded(rays, load<I>(b.shadow.exclude.at(i)), c.counters->trace);
        add_radiance(b, i, active && !blocked, load_color<F>(b.throughput, i) * light);
    }
}

// Every lit surface point samples the light that `light_at` gives it: (shading, packet) -> light and weight.
template <class Real, class LightAt>
void light_pass(StageContext<Real>& c, DimId dimension, bool has_area, LightAt light_at) {
    using F = typename Pack<Real>::F;
    RayBatch<Real>& b = *c.batch;
    if (has_area) sample_light_points(c, dimension);
    bool lit = false;
    for (int i = 0; i < b.count; i += Pack<Real>::width) {
        const Shading<Real> s = load_shading(*c.world, b, i);
        if (!any(s.active)) {
            store_color(Color3<F>(F(0)), b.shadow.light, i);
            continue;
        }
        const auto& light = light_at(i);  // a reference, or a value whose life it prolongs
        lit = sample_packet(b.shadow, i, s, light.first, light.second) || lit;
    }
    if (lit) trace_shadow_rays(c);
}

// All lights of one kind: each of them, or a few chosen by power, stratified.
template <class Real, template <class> class Kind>
void light_from_all(StageContext<Real>& c, const LightList<Kind, Real>& list, int& light_number) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using U = typename P::U;
    constexpr bool has_area = !std::is_same_v<Kind<Real>, PointLightData<Real>>;
    const RayBatch<Real>& b = *c.batch;
    const auto next_dimension = [&] { return dim(HitDim::light, b.bounce, light_number++); };
    if (list.ask_all()) {
        for (const Kind<Real>& l : list.lights) {
            const std::pair<Kind<R>, F> light{cast<R>(l), F(1)};
            const auto same = [&](int) -> const auto& { return light; };
            light_pass(c, next_dimension(), has_area, same);
        }
        return;
    }
    const DimId choice = dim(HitDim::light_choice, b.bounce, light_number);
    for (int pick_number = 0; pick_number < lights_per_choice; ++pick_number)
        light_pass(c, next_dimension(), has_area, [&](int i) {
            const SampleSet<F> samples{load<U>(b.key.at(i)), load<U>(b.index.at(i))};
            const F u = sample_1d(c.world->sampling.kind, samples, choice);
            const Choice<F> chosen = choose(list.choice, F((u + F(float(pick_number))) * F(1.0f / lights_per_choice)));
            return std::pair{pick<R>(list.lights, chosen.index), F(F(1.0f / lights_per_choice) / chosen.probability)};
        });
}

}  // namespace

template <class Real>
void light_stage(StageContext<Real>& c) {
    const LightTable<Real>& lights = c.world->lights;
    int light_number = 0;  // names the sample dimensions of each light
    light_from_all(c, lights.points, light_number);
    light_from_all(c, lights.rects, light_number);
    light_from_all(c, lights.spheres, light_number);
}

template void light_stage(StageContext<float>&);
template void light_stage(StageContext<double>&);

}  // namespace drt
