#include "drt/light/light_sample.h"
#include "drt/material/phong.h"
#include "drt/stages/accumulate.h"
#include "drt/stages/stages.h"

namespace drt {

// Light by light (or choice by choice), each in three loops over the batch: sample the light, shade, ask for
// visibility. What is done for one packet is a chain in which every step waits for the one before;
// in short loops the machine overlaps several packets, and across a query it overlaps none.

namespace {

// What the points on all lights of a hit have in common.
template <class Real>
void draw_light_digits(StageContext<Real>& c) {
    using P = Pack<Real>;
    using F = typename P::F;
    using U = typename P::U;
    RayBatch<Real>& b = *c.batch;
    if (c.world->sampling.kind == SamplerKind::independent) return;
    for (int i = 0; i < b.count; i += P::width) {
        const SlotSamples<F> samples{load<U>(b.key.at(i)), load<U>(b.hit_index.at(i))};
        const PointDigits<F> p = scrambled_digits(samples, hit_dim(b.bounce));
        store(p.x, b.shadow.digits_x.at(i));
        store(p.y, b.shadow.digits_y.at(i));
    }
}

// A point of the unit square for a light.
template <class Real>
[[gnu::always_inline]] inline Vec2<typename Pack<Real>::R> light_point(const StageContext<Real>& c, int i,
                                                                       DimId dimension) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using U = typename Pack<Real>::U;
    const RayBatch<Real>& b = *c.batch;
    const U key = load<U>(b.key.at(i));
    const Vec2<F> u =
        c.world->sampling.kind == SamplerKind::independent
            ? sample_2d(SamplerKind::independent, SlotSamples<F>{key, load<U>(b.hit_index.at(i))}, dimension)
            : shifted_point(PointDigits<F>{load<U>(b.shadow.digits_x.at(i)), load<U>(b.shadow.digits_y.at(i))}, key,
                            dimension);
    return {num_cast<R>(u.x), num_cast<R>(u.y)};
}

// One sample of a light (each lane may have a light of its own) for packet i: into the batch's shadow rays, with the
// light that arrives.
template <class Real, class Light>
[[gnu::always_inline]] inline void sample_packet(RayBatch<Real>& b, int i, const Light& light,
                                                 const Vec2<typename Pack<Real>::R>& u,
                                                 const typename Pack<Real>::F& weight) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const LightSample<R> sample = sample_light(light, load3<R>(b.p, i), u);
    // In front by the same normal, in the precision that decides which side the shadow ray leaves on.
    const auto in_front = mask_cast<F>(dot(load3<R>(b.n, i), sample.wi) > R(0));
    const auto lit = mask_cast<F>(load<I>(b.material.at(i)) >= I(0)) && sample.lit && in_front;
    store_color(select(lit, sample.intensity * weight, Color3<F>(F(0))), b.shadow.light, i);
    store3(sample.wi, b.shadow.d, i);
    store(sample.distance, b.shadow.distance.at(i));
    store(light.body, b.shadow.exclude.at(i));
}

// Turns the light that arrives at packet i into the light that is reflected by Phong's terms. False if there is none.
template <class Real>
[[gnu::always_inline]] inline bool shade_packet(const World<Real>& w, RayBatch<Real>& b, int i) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const Color3<F> light = load_color<F>(b.shadow.light, i);
    if (!any(max_component(light) > F(0))) return false;
    const Vec3<F> n(load3<R>(b.n, i)), wi(load3<R>(b.shadow.d, i));
    const F cosine = dot(n, wi);
    PhongParameters<F> phong;
    phong.diffuse = load_color<F>(b.albedo, i);
    Color3<F> f = phong_diffuse(phong, cosine);
    if (w.features.specular) {
        const I material = max(load<I>(b.material.at(i)), I(0));
        phong.specular = gather_color<F>(w.materials.specular, material);
        if (any(max_component(phong.specular) > F(0))) {
            phong.shininess = gather_coherent<F>(w.materials.shininess.data(), material);
            f += phong_specular(phong, n, wi, -Vec3<F>(load3<R>(b.d, i)), cosine);
        }
    }
    store_color(f * light, b.shadow.light, i);
    return true;
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

// Every surface point samples the light that `light_at` gives it: packet -> light and weight.
template <class Real, class LightAt>
void light_pass(StageContext<Real>& c, DimId dimension, bool has_area, LightAt light_at) {
    using R = typename Pack<Real>::R;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += Pack<Real>::width) {
        const auto& light = light_at(i);  // a reference, or a value whose life it prolongs
        const Vec2<R> u = has_area ? light_point(c, i, dimension) : Vec2<R>{};
        sample_packet(b, i, light.first, u, light.second);
    }
    bool lit = false;
    for (int i = 0; i < b.count; i += Pack<Real>::width) lit = shade_packet(*c.world, b, i) || lit;
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
    static_assert(3 * few_lights <= most_numbers);
    int light_number = 0;  // names the sample dimensions of each light
    if (!lights.rects.lights.empty() || !lights.spheres.lights.empty()) draw_light_digits(c);
    light_from_all(c, lights.points, light_number);
    light_from_all(c, lights.rects, light_number);
    light_from_all(c, lights.spheres, light_number);
}

template void light_stage(StageContext<float>&);
template void light_stage(StageContext<double>&);

}  // namespace drt
