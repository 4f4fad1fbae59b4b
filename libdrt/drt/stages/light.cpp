#include "drt/light/light_sample.h"
#include "drt/material/phong.h"
#include "drt/stages/accumulate.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

// What the light loop needs of a packet of surface points.
template <class Real>
struct Shading {
    using P = Pack<Real>;
    Vec3<typename P::R> p, n;
    Vec3<typename P::F> nf, wo;
    PhongParameters<typename P::F> phong;
    SampleSet<typename P::F> samples;
    typename P::F time;
    typename P::I start;
    typename P::Mask active;
    bool shiny = false;  // some lane has highlights
};

template <class Real>
Shading<Real> load_shading(const World<Real>& w, const RayBatch<Real>& b, int i) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    using U = typename P::U;
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
        s.phong.shininess = gather<F>(w.materials.shininess.data(), safe);
        s.shiny = any(max_component(s.phong.specular) > F(0));
    }
    s.samples = {load<U>(b.key.at(i)), load<U>(b.index.at(i))};
    s.time = load<F>(b.time.at(i));
    // A shadow ray leaves on the side that n points to: outward if that is ng's side.
    s.start = start::pack(load<I>(b.body.at(i)), load<I>(b.part.at(i)), load<I>(b.outward.at(i)));
    s.active = mask_cast<F>(material >= I(0));
    return s;
}

// Phong's terms for one light sample; zero where the light is behind the surface.
template <class Real>
Color3<typename Pack<Real>::F> shade(const Shading<Real>& s, const Vec3<typename Pack<Real>::F>& wi) {
    using F = typename Pack<Real>::F;
    const F cosine = dot(s.nf, wi);
    Color3<F> f = phong_diffuse(s.phong, cosine);
    if (s.shiny) f += phong_specular(s.phong, s.nf, wi, s.wo, cosine);
    return f;
}

// One sample of one light (each lane may have its own): sampled, tested for visibility, shaded.
template <class Real, class Light>
Color3<typename Pack<Real>::F> light_from(StageContext<Real>& c, const Shading<Real>& s, const Light& light,
                                          DimId dimension) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    Vec2<R> u;
    if constexpr (!std::is_same_v<Light, PointLightData<R>>) {
        const Vec2<F> uf = sample_2d(c.world->sampling.kind, s.samples, dimension);
        u = {num_cast<R>(uf.x), num_cast<R>(uf.y)};
    }
    const LightSample<R> sample = sample_light(light, s.p, u);
    const Color3<F> reflected = shade(s, Vec3<F>(sample.wi)) * sample.intensity;
    // In front by the same normal, in the precision that decides which side the shadow ray leaves on.
    const auto in_front = mask_cast<F>(dot(s.n, sample.wi) > R(0));
    const auto active = s.active && sample.lit && in_front && max_component(reflected) > F(0);
    if (!any(active)) return Color3<F>(F(0));
    c.counters->shadow_rays += std::uint64_t(count(active));
    constexpr Real almost = 1 - 8 * std::numeric_limits<Real>::epsilon();  // what the light touches does not hide it
    const RayPacket<Real> rays{s.p, sample.wi, sample.distance * R(almost), s.time, s.start, active};
    const auto blocked = c.world->accel->occluded(rays, light.body, c.counters->trace);
    return select(active && !blocked, reflected, Color3<F>(F(0)));
}

// All lights of one kind: each of them, or a few chosen by power, stratified.
template <class Real, template <class> class Kind>
Color3<typename Pack<Real>::F> light_from_all(StageContext<Real>& c, const Shading<Real>& s,
                                              const LightList<Kind, Real>& list, int& light_number) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    const int bounce = c.batch->bounce;
    Color3<F> sum(F(0));
    if (list.ask_all()) {
        for (const Kind<Real>& l : list.lights)
            sum += light_from(c, s, cast<R>(l), dim(HitDim::light, bounce, light_number++));
        return sum;
    }
    constexpr int picks = lights_per_choice;
    const F u = sample_1d(c.world->sampling.kind, s.samples, dim(HitDim::light_choice, bounce, light_number));
    for (int i = 0; i < picks; ++i) {
        const Choice<F> chosen = choose(list.choice, F((u + F(float(i))) * F(1.0f / picks)));
        const Kind<R> light = pick<R>(list.lights, chosen.index);
        sum += light_from(c, s, light, dim(HitDim::light, bounce, light_number++)) *
               (F(1.0f / picks) / chosen.probability);
    }
    return sum;
}

}  // namespace

template <class Real>
void light_stage(StageContext<Real>& c) {
    using F = typename Pack<Real>::F;
    const LightTable<Real>& lights = c.world->lights;
    RayBatch<Real>& b = *c.batch;
    for (int i = 0; i < b.count; i += Pack<Real>::width) {
        const Shading<Real> s = load_shading(*c.world, b, i);
        if (!any(s.active)) continue;
        int light_number = 0;  // names the sample dimensions of each light
        Color3<F> sum = light_from_all(c, s, lights.points, light_number);
        sum += light_from_all(c, s, lights.rects, light_number);
        sum += light_from_all(c, s, lights.spheres, light_number);
        add_radiance(b, i, s.active, load_color<F>(b.throughput, i) * sum);
    }
}

template void light_stage(StageContext<float>&);
template void light_stage(StageContext<double>&);

}  // namespace drt
