#include <limits>

#include "drt/sampling/lobe.h"
#include "drt/stages/glossy_lights.h"
#include "drt/stages/media.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

// Cuts what materials have brightened beyond the largest float: infinity times black would be no number at all.
template <class F>
void cut_brightness(Color3<F>& throughput, const MaskOf<F>& live, RenderCounters& counters) {
    using std::abs;
    const F largest(std::numeric_limits<float>::max());
    const auto within = abs(throughput.r) <= largest && abs(throughput.g) <= largest && abs(throughput.b) <= largest;
    if (all(within || !live)) return;
    counters.cut_paths += std::uint64_t(count(live && !within));
    for (F* channel : {&throughput.r, &throughput.g, &throughput.b}) *channel = clamp(*channel, F(-largest), largest);
}

template <class Real>
struct Directions {
    using P = Pack<Real>;
    Vec3<typename P::R> d;      // the new direction, before its lobe
    typename P::I lobe;         // index of its glossy lobe, or sharp
    typename P::Mask refracts;  // it crosses the surface
    typename P::Mask reflects;  // by choice, not by total internal reflection
};

template <class R>
Vec3<R> mirror(const Vec3<R>& v, const Vec3<R>& n) {
    return v - n * (R(2) * dot(v, n));
}

// n1 and n2 for the lanes that try to cross; the stack is per path, so lane by lane.
template <class Real>
std::pair<typename Pack<Real>::R, typename Pack<Real>::R> indices_at(const World<Real>& w, RayBatch<Real>& b, int i,
                                                                     const typename Pack<Real>::Mask& lanes) {
    using R = typename Pack<Real>::R;
    R n1(1), n2(1);
    const auto index_of = [&](int body) {
        return body == no_body ? 1.0f : w.materials.refraction_index[size_t(w.body_material[size_t(body)])];
    };
    for (int l = 0; l < Pack<Real>::width; ++l) {
        if (!lane_bit(lanes, l)) continue;
        const MediaStack<Real> stack(b, b.slot[i + l]);
        const Interface f = interface_at<Real>(stack, b.body[i + l], b.outward[i + l] != 0, w.bodies.roles);
        n1[l] = Real(index_of(f.before));
        n2[l] = Real(index_of(f.beyond));
    }
    return {n1, n2};
}

template <class Real>
void cross_surfaces(const World<Real>& w, RayBatch<Real>& b, int i, const typename Pack<Real>::Mask& lanes,
                    RenderCounters& counters) {
    for (int l = 0; l < Pack<Real>::width; ++l) {
        if (!lane_bit(lanes, l)) continue;
        MediaStack<Real> stack(b, b.slot[i + l]);
        if (!cross<Real>(stack, b.body[i + l], b.outward[i + l] != 0, w.bodies.roles)) ++counters.media_overflows;
    }
}

// Mirror direction; or, with probability refraction / (reflectance + refraction), the refracted one. Total internal
// reflection sends the refracted share into the mirror direction, with refraction's own spread.
template <class Real>
Directions<Real> choose_direction(const World<Real>& w, RayBatch<Real>& b, int i,
                                  const SampleSet<typename Pack<Real>::F>& samples,
                                  const typename Pack<Real>::I& material, const typename Pack<Real>::Mask& live) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    using std::sqrt;
    const Vec3<R> d = load3<R>(b.d, i), n = load3<R>(b.n, i);
    Directions<Real> out{mirror(d, n), gather_coherent<I>(w.materials.reflection_lobe.data(), material),
                         typename P::Mask(false), typename P::Mask(true)};
    if (w.features.refraction) {
        const F kr = gather_coherent<F>(w.materials.reflectance.data(), material);
        const F kt = gather_coherent<F>(w.materials.refraction.data(), material);
        const F choice = sample_1d(w.sampling.kind, samples, dim(HitDim::lobe_choice, b.bounce));
        const auto through = live && choice * (kr + kt) >= kr && kt > F(0);
        if (!any(through)) return out;
        const auto [n1, n2] = indices_at(w, b, i, through);
        const R eta = n1 / n2;
        const R c = dot(d, n);
        const R s2 = eta * eta * max(R(1) - c * c, R(0));
        const auto crosses = through && mask_cast<F>(s2 <= R(1));
        const Vec3<R> t = d * eta - n * (eta * c + sqrt(max(R(1) - s2, R(0))));
        out.d = select(mask_cast<R>(crosses), normalize(t), out.d);
        out.lobe =
            select(mask_cast<I>(through), gather_coherent<I>(w.materials.refraction_lobe.data(), material), out.lobe);
        out.refracts = crosses;
        out.reflects = !through;
    }
    return out;
}

template <class Real>
Vec3<typename Pack<Real>::R> spread_lobe(const World<Real>& w, const RayBatch<Real>& b, const Directions<Real>& dir,
                                         const SlotSamples<typename Pack<Real>::F>& samples) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using I = typename Pack<Real>::I;
    const auto glossy = dir.lobe != I(sharp);
    if (!any(glossy)) return dir.d;
    const Vec2<F> u = sample_2d(w.sampling.kind, samples, dim(HitDim::lobe, b.bounce));
    const F theta = lobe_theta(w.materials.lobes, max(dir.lobe, I(0)), u.x);
    const Vec3<R> bent = lobe_direction(frame_around(dir.d), num_cast<R>(theta), num_cast<R>(u.y));
    return select(mask_cast<R>(glossy), bent, dir.d);
}

// Unbiased early end of paths that can hardly matter any more, from the depth where it pays.
template <class Real>
typename Pack<Real>::Mask survive(const World<Real>& w, const RayBatch<Real>& b,
                                  const SampleSet<typename Pack<Real>::F>& samples,
                                  Color3<typename Pack<Real>::F>& throughput) {
    using F = typename Pack<Real>::F;
    using std::abs;
    const F largest = max(abs(throughput.r), max(abs(throughput.g), abs(throughput.b)));
    if (b.bounce < w.sampling.roulette_depth) return largest > F(0);
    const F p = min(largest * F(1 / w.sampling.roulette_threshold), F(1));
    const auto alive = sample_1d(w.sampling.kind, samples, dim(HitDim::roulette, b.bounce)) < p;
    throughput *= F(1) / max(p, F(1e-30f));
    return alive && largest > F(0);
}

}  // namespace

template <class Real>
void scatter_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    using U = typename P::U;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    const int count_before = b.bounce < w.sampling.max_depth ? b.count : 0;
    const Departures<Real> rays = departures_of_rays(b), arrivals = departures_of_shadow_rays(b, rays);
    int out = 0;
    for (int i = 0; i < count_before; i += P::width) {
        const I raw_material = load<I>(b.material.at(i));
        const I material = max(raw_material, I(0));
        F share = gather_coherent<F>(w.materials.reflectance.data(), material);
        if (w.features.refraction) share += gather_coherent<F>(w.materials.refraction.data(), material);
        auto live = mask_cast<F>(raw_material >= I(0)) && share > F(0);
        if (!any(live)) continue;
        Color3<F> throughput = load_color<F>(b.throughput, i) * share;
        if (w.features.brightens) cut_brightness(throughput, live, *c.counters);
        const SampleSet<F> samples = sample_of<F>(b, i);
        live = live && survive(w, b, samples, throughput);
        if (!any(live)) continue;
        const Directions<Real> dir = choose_direction(w, b, i, samples, material, live);
        Vec3<R> d = dir.d;
        if (w.features.glossy) d = spread_lobe(w, b, dir, {samples.key, load<U>(b.hit_index.at(i))});
        // A lobe's tail that ends on the wrong side of the surface is mirrored back about the tangent plane.
        const Vec3<R> n = load3<R>(b.n, i);
        const auto below = dot(d, n) < R(0);
        d = normalize(select(below != mask_cast<R>(dir.refracts), mirror(d, n), d));
        if (w.features.refraction) cross_surfaces(w, b, i, live && dir.refracts, *c.counters);
        const I came_outward = load<I>(b.outward.at(i));
        const I leaves_outward = select(mask_cast<I>(dir.refracts), I(1) - came_outward, came_outward);
        const I start = start::pack(load<I>(b.body.at(i)), load<I>(b.part.at(i)), leaves_outward);
        F lobe_density(0);
        if (w.features.lobe_lights) {
            const auto lobe = reflection_lobe(w, b, i, material);
            lobe_density = select(dir.reflects, lobe.choice * density_along(w, lobe, d), F(0));
        }

        // Stable compaction in place: `out` never overtakes the packet at hand, which is in registers from here on.
        const auto keep = [&](auto& column, const auto& v) {
            using V = std::decay_t<decltype(v)>;
            compress_store(mask_cast<V>(live), v, column.at(out));
        };
        const Vec3<R> p = load3<R>(b.p, i);
        const Arrival<R> arrival = arrival_at<R>(arrivals, i, largest_coordinate(p));
        const F time = load<F>(b.time.at(i));
        const I slot = load<I>(b.slot.at(i));
        keep(b.o.x, p.x), keep(b.o.y, p.y), keep(b.o.z, p.z);
        keep(b.d.x, d.x), keep(b.d.y, d.y), keep(b.d.z, d.z);
        keep(b.arrival.x, arrival.d.x), keep(b.arrival.y, arrival.d.y), keep(b.arrival.z, arrival.d.z);
        keep(b.travelled, arrival.travelled), keep(b.came_from, arrival.came_from);
        keep(b.time, time);
        if (w.features.textures) {
            const F footprint = load<F>(b.footprint.at(i)), spread = load<F>(b.spread.at(i));
            keep(b.footprint, footprint), keep(b.spread, spread);
        }
        keep(b.start, start), keep(b.slot, slot);
        keep(b.key, samples.key), keep(b.index, samples.index);
        keep(b.hit_index, at_slot(w.sampling.kind, samples, hit_dim(b.bounce + 1)).index);
        if (w.features.lobe_lights) {
            keep(b.lobe.density, lobe_density), keep(b.lobe.passed, F(0));
            keep(b.lobe.n.x, num_cast<F>(n.x)), keep(b.lobe.n.y, num_cast<F>(n.y)), keep(b.lobe.n.z, num_cast<F>(n.z));
        }
        keep(b.throughput.x, throughput.r), keep(b.throughput.y, throughput.g), keep(b.throughput.z, throughput.b);
        out += count(live);
    }
    store(I(-1), b.slot.at(out));  // the last packet's unused lanes
    b.count = out;
    ++b.bounce;
    c.counters->scattered_rays += std::uint64_t(out);
}

template void scatter_stage(StageContext<float>&);
template void scatter_stage(StageContext<double>&);

}  // namespace drt
