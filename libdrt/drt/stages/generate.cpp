#include "drt/sampling/shutter.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

template <class Real>
struct PathStart {
    using P = Pack<Real>;
    Vec2<typename P::R> position;  // on the film, pixels
    typename P::F weight;
    typename P::F time;
};

// Each dimension is found by its name, so one that is not drawn never shifts the others.
template <class Real, bool filtered, bool timed>
PathStart<Real> start_path(const World<Real>& w, const SampleSet<typename Pack<Real>::F>& set,
                           const Vec2<typename Pack<Real>::R>& pixel) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    PathStart<Real> out;
    out.position = {pixel.x + R(Real(0.5)), pixel.y + R(Real(0.5))};
    out.weight = F(1);
    out.time = F(0);
    if constexpr (filtered) {
        const Vec2<F> u = sample_2d(w.sampling.kind, set, dim(PathDim::filter));
        const FilterSample<F> s = sample_filter(w.filter, u);
        out.position = {out.position.x + num_cast<R>(s.offset.x), out.position.y + num_cast<R>(s.offset.y)};
        out.weight = s.weight;
    }
    if constexpr (timed)
        out.time = shutter_time(sample_1d(w.sampling.kind, set, dim(PathDim::time)), F(w.camera.switch_ratio));
    return out;
}

template <class Real, bool filtered, bool has_lens, bool timed, bool moving_camera>
void generate(StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    using U = typename P::U;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    View<R> view = cast<R>(w.view);
    const bool point = w.filter.spec.kind == FilterKind::point;
    const float pixel_spread = float(w.view.pixel_size) * (point ? 1.0f : 0.5f);  // docs/images-and-textures.md
    int slot = 0;
    for (int s = 0; s < c.samples; ++s) {
        const std::uint32_t sample = c.first_sample + std::uint32_t(s);
        for (int i = 0; i < c.pixels->count; i += P::width, slot += P::width) {
            const I x = load<I>(&c.pixels->x[size_t(i)]), y = load<I>(&c.pixels->y[size_t(i)]);
            const SampleSet<F> set{sample_key<U>(w.sampling.seed, w.sampling.frame, std::uint32_t(replicate_of(sample)),
                                                 num_cast<U>(x), num_cast<U>(y)),
                                   U(index_in_replicate(sample))};
            const PathStart<Real> path = start_path<Real, filtered, timed>(w, set, {num_cast<R>(x), num_cast<R>(y)});
            if constexpr (moving_camera) view = view_at(w.camera, num_cast<R>(path.time));
            Vec2<F> lens_uv;
            if constexpr (has_lens) lens_uv = sample_2d(w.sampling.kind, set, dim(PathDim::lens));
            const CameraRay<R> ray = camera_ray<has_lens>(view, w.camera.film, w.camera.lens, path.position,
                                                          {num_cast<R>(lens_uv.x), num_cast<R>(lens_uv.y)});
            store3(ray.o, b.o, slot);
            store3(ray.d, b.d, slot);
            store(path.time, b.time.at(slot));
            store(I(start::none), b.start.at(slot));
            const I lanes = iota<I>();
            store(select(lanes < I(c.pixels->count - i), lanes + slot, I(-1)), b.slot.at(slot));
            store(set.key, b.key.at(slot));
            store(set.index, b.index.at(slot));
            store_color(Color3<F>(path.weight), b.throughput, slot);
            store(F(0), b.footprint.at(slot));
            store(F(pixel_spread), b.spread.at(slot));
            store_color(Color3<F>(F(0)), b.radiance, slot);
            store(F(0), b.alpha.at(slot));
            store(lanes + i, b.pixel.at(slot));
            store(U(sample), b.sample.at(slot));
        }
    }
    b.count = b.slots = slot;
    b.bounce = 0;
    std::fill(b.media_count.begin(), b.media_count.end(), 0);
    c.counters->camera_rays += std::uint64_t(c.pixels->count) * std::uint64_t(c.samples);
}

template <class Real, bool... chosen>
StageFunction<Real> choose() {
    return generate<Real, chosen...>;
}
// Turns run-time flags into template arguments, one after another.
template <class Real, bool... chosen, class... Rest>
StageFunction<Real> choose(bool next, Rest... rest) {
    return next ? choose<Real, chosen..., true>(rest...) : choose<Real, chosen..., false>(rest...);
}

}  // namespace

template <class Real>
StageFunction<Real> generate_stage(const Features& f) {
    return choose<Real>(f.pixel_filter, f.lens, f.time, f.moving_camera);
}

template StageFunction<float> generate_stage(const Features&);
template StageFunction<double> generate_stage(const Features&);

}  // namespace drt
