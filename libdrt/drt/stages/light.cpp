#include "drt/light/light_choice.h"
#include "drt/light/light_sample.h"
#include "drt/material/phong.h"
#include "drt/stages/accumulate.h"
#include "drt/stages/glossy_lights.h"
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

// A sample of a light (each lane may have a light of its own) for packet i: into the batch's shadow rays, with the
// light that arrives. It is one of `samples` that are taken of the light in the mean.
template <class Real>
[[gnu::always_inline]] inline void store_sample(const Features& features, RayBatch<Real>& b, int i,
                                                const LightSample<typename Pack<Real>::R>& sample,
                                                const typename Pack<Real>::I& body,
                                                const typename Pack<Real>::F& samples) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    // In front by the same normal, in the precision that decides which side the shadow ray leaves on.
    const auto in_front = mask_cast<F>(dot(load3<R>(b.n, i), sample.wi) > R(0));
    const auto lit = mask_cast<F>(load<I>(b.material.at(i)) >= I(0)) && sample.lit && in_front;
    store_color(select(lit, intensity(sample, samples), Color3<F>(F(0))), b.shadow.light, i);
    store3(sample.wi, b.shadow.d, i);
    store(sample.distance, b.shadow.distance.at(i));
    store(body, b.shadow.exclude.at(i));
    if (features.lobe_lights) {
        const auto met_by_lobes = !sample.is_delta && mask_cast<F>(body >= I(0));
        store(select(met_by_lobes, sample.pdf * samples, F(0)), b.shadow.density.at(i));
    }
}

// What the glossy reflection makes of the light samples of packet i, as a factor of I_l = radiance / (pi density).
template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::F glossy_factor(const World<Real>& w, const RayBatch<Real>& b,
                                                                   int i) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    const F density = load<F>(b.shadow.density.at(i));
    const auto known = density > F(0);
    if (!any(known)) return F(0);
    const auto lobe = reflection_lobe(w, b, i, max(load<I>(b.material.at(i)), I(0)));
    const F along = density_along(w, lobe, load3<R>(b.shadow.d, i));
    const F weight = power_heuristic(select(known, density, F(1)), F(lobe.choice * along));
    return select(known, F(pi<float>) * lobe.reflectance * along * weight, F(0));
}

// Turns the light that arrives at packet i into the light that is reflected by Phong's terms, and by the glossy
// reflection where its rays go on. False if there is none.
template <bool lobes, class Real>
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
    if constexpr (lobes) f += Color3<F>(glossy_factor(w, b, i));
    store_color(f * light, b.shadow.light, i);
    return true;
}

// False if no ray carries any light.
template <bool lobes, class Real>
bool shade(const World<Real>& w, RayBatch<Real>& b) {
    bool lit = false;
    for (int i = 0; i < b.count; i += Pack<Real>::width) lit = shade_packet<lobes>(w, b, i) || lit;
    return lit;
}

// Adds what the shadow rays carry where nothing is in their way.
template <class Real>
void trace_shadow_rays(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    const Departures<Real> rays_from = departures_of_rays(b), from = departures_of_shadow_rays(b, rays_from);
    for (int i = 0; i < b.count; i += P::width) {
        const Color3<F> light = load_color<F>(b.shadow.light, i);
        const auto active = max_component(light) > F(0);
        if (!any(active)) continue;
        c.counters->shadow_rays += std::uint64_t(count(active));
        // A shadow ray leaves on the side that n points to: outward if that is ng's side.
        const I start = start::pack(load<I>(b.body.at(i)), load<I>(b.part.at(i)), load<I>(b.outward.at(i)));
        const RayPacket<Real> rays{load3<R>(b.p, i),
                                   load3<R>(b.shadow.d, i),
                                   load<R>(b.shadow.distance.at(i)),
                                   load<F>(b.time.at(i)),
                                   start,
                                   active,
                                   &from,
                                   i};
        const auto blocked = c.world->accel->occluded(rays, load<I>(b.shadow.exclude.at(i)), c.counters->trace);
        add_radiance(b, i, active && !blocked, load_color<F>(b.throughput, i) * light);
    }
}

// Shades the samples in the batch's shadow rays and adds those that nothing hides.
template <class Real>
void shade_and_trace(StageContext<Real>& c) {
    const World<Real>& w = *c.world;
    const bool lobes = w.features.lobe_lights && c.batch->bounce < w.sampling.max_depth;
    if (lobes ? shade<true>(w, *c.batch) : shade<false>(w, *c.batch)) trace_shadow_rays(c);
}

// The same as for other rectangles, but long. Out of the way, so that those keep their values in registers.
template <class Real, class Light>
[[gnu::noinline]] void sample_near_packet(StageContext<Real>& c, int i, const Light& light,
                                          Vec2<typename Pack<Real>::R> u) {
    using P = Pack<Real>;
    RayBatch<Real>& b = *c.batch;
    const auto sample = sample_light(light, load3<typename P::R>(b.p, i), u);
    store_sample(c.world->features, b, i, sample, light.body, typename P::F(1));
}

// Every surface point samples the same light.
template <class Real, template <class> class Kind>
void ask_light(StageContext<Real>& c, const Kind<Real>& l, DimId dimension) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    constexpr bool has_area = !std::is_same_v<Kind<Real>, PointLightData<Real>>;
    RayBatch<Real>& b = *c.batch;
    const Kind<R> light = cast<R>(l);
    for (int i = 0; i < b.count; i += Pack<Real>::width) {
        const Vec2<R> u = has_area ? light_point(c, i, dimension) : Vec2<R>{};
        const Vec3<R> p = load3<R>(b.p, i);
        if constexpr (std::is_same_v<Kind<Real>, RectLightData<Real>>) {
            if (any(is_near(light, p)))
                sample_near_packet(c, i, light, u);
            else
                store_sample(c.world->features, b, i, sample_area(light, p, u), light.body, F(1));
        } else {
            store_sample(c.world->features, b, i, sample_light(light, p, u), light.body, F(1));
        }
    }
    shade_and_trace(c);
}

// Every surface point samples the light that was drawn for it.
template <class Real>
void ask_drawn_lights(StageContext<Real>& c, const LightDraws& draws, DimId dimension) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += Pack<Real>::width) {
        const I id = load<I>(draws.light.at(i));
        const Vec2<R> u = c.world->features.light_samples ? light_point(c, i, dimension) : Vec2<R>{};
        const PickedSample<R> picked = sample_picked(c.world->lights, id, load3<R>(b.p, i), u);
        store_sample(c.world->features, b, i, picked.sample, picked.body, load<F>(draws.samples.at(i)));
    }
    shade_and_trace(c);
}

// The light tree draws for every hit, none for the unused lanes of the last packet. One hit after the other: lanes hold
// the children of a node.
template <class Real>
void draw_from_tree(StageContext<Real>& c) {
    RayBatch<Real>& b = *c.batch;
    const DimId dimension = dim(HitDim::light_tree, b.bounce);
    constexpr int width = Pack<Real>::width;
    const int whole_packets = (b.count + width - 1) / width * width;
    std::array<TreePoint<Real>, points_at_once> points;
    std::array<int, points_at_once> hits;
    size_t waiting = 0;
    const auto store_draws = [&](int i, const TreeDraws& drawn) {
        for (size_t k = 0; k < drawn.size(); ++k) {
            b.drawn[k].light[i] = drawn[k].light;
            b.drawn[k].samples[i] = float(tree_draws) * drawn[k].probability;
        }
    };
    const auto choose = [&] {
        std::array<TreeDraws, points_at_once> drawn;
        choose_lights<Real>(c.world->lights.tree, std::span(points).first(waiting), drawn.data());
        for (size_t k = 0; k < waiting; ++k) store_draws(hits[k], drawn[k]);
        waiting = 0;
    };
    for (int i = 0; i < whole_packets; ++i) {
        if (b.slot[i] < 0 || b.material[i] < 0) {
            store_draws(i, {});
            continue;
        }
        const Vec2<float> u = sample_2d(c.world->sampling.kind, sample_of<float>(b, i), dimension);
        points[waiting] = {{b.p.x[i], b.p.y[i], b.p.z[i]},
                           {float(b.n.x[i]), float(b.n.y[i]), float(b.n.z[i])},
                           std::uint32_t(u.x * 0x1p24f) << 8,
                           std::uint32_t(u.y * 0x1p24f) << 8};
        hits[waiting++] = i;
        if (waiting == points_at_once) choose();
    }
    choose();
}

// Lights without falloff, by power.
template <class Real>
void draw_by_power(StageContext<Real>& c, int draw) {
    using P = Pack<Real>;
    using F = typename P::F;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    const PowerChoice& plain = c.world->lights.plain;
    const DimId dimension = dim(HitDim::light_choice, b.bounce);
    for (int i = 0; i < b.count; i += P::width) {
        const F u = sample_1d(c.world->sampling.kind, sample_of<F>(b, i), dimension);
        const Choice<F> chosen = choose(plain.by_power, F((u + F(float(draw))) * F(1.0f / plain_draws)));
        store(gather<I>(plain.lights.data(), chosen.index), b.drawn[size_t(draw)].light.at(i));
        store(F(chosen.probability * F(plain_draws)), b.drawn[size_t(draw)].samples.at(i));
    }
}

}  // namespace

template <class Real>
void light_stage(StageContext<Real>& c) {
    const LightTable<Real>& lights = c.world->lights;
    static_assert(2 * few_lights + tree_draws + plain_draws <= most_numbers);
    const RayBatch<Real>& b = *c.batch;
    int light_number = 0;  // names the sample dimensions of each light
    const auto next_dimension = [&] { return dim(HitDim::light, b.bounce, light_number++); };
    if (c.world->features.light_samples) draw_light_digits(c);
    for (const LightId id : lights.asked)
        visit_light(lights, id, [&](const auto& light) { ask_light(c, light, next_dimension()); });
    if (!lights.tree.empty()) {
        draw_from_tree(c);
        for (const LightDraws& draws : b.drawn) ask_drawn_lights(c, draws, next_dimension());
    }
    if (!lights.plain.lights.empty()) {
        for (int k = 0; k < plain_draws; ++k) {
            draw_by_power(c, k);
            ask_drawn_lights(c, b.drawn[size_t(k)], next_dimension());
        }
    }
}

template void light_stage(StageContext<float>&);
template void light_stage(StageContext<double>&);

}  // namespace drt
