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
template <class Real>
PathStart<Real> start_path(const World<Real>& w, const SampleSet<typename Pack<Real>::F>& set,
                           const Vec2<typename Pack<Real>::R>& pixel) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    PathStart<Real> out;
    out.position = {pixel.x + R(Real(0.5)), pixel.y + R(Real(0.5))};
    out.weight = F(1);
    out.time = F(0);
    if (w.features.pixel_filter) {
        const Vec2<F> u = sample_2d(w.sampling.kind, set, dim(PathDim::filter));
        const FilterSample<F> s = sample_filter(w.filter, u);
        out.position = {out.position.x + num_cast<R>(s.offset.x), out.position.y + num_cast<R>(s.offset.y)};
        out.weight = s.weight;
    }
    if (w.features.time)
        out.time = shutter_time(sample_1d(w.sampling.kind, set, dim(PathDim::time)), F(w.camera.switch_ratio));
    return out;
}

template <class Real>
CameraRay<typename Pack<Real>::R> make_ray(const World<Real>& w, const View<typename Pack<Real>::R>& view,
                                           const SampleSet<typename Pack<Real>::F>& set, const PathStart<Real>& path) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    if (!w.features.lens) return camera_ray<false>(view, w.camera.film, w.camera.lens, path.position, {});
    const Vec2<F> u = sample_2d(w.sampling.kind, set, dim(PathDim::lens));
    return camera_ray<true>(view, w.camera.film, w.camera.lens, path.position, {num_cast<R>(u.x), num_cast<R>(u.y)});
}

}  // namespace

template <class Real>
void generate_stage(StageContext<Real>& c) {
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
        for (int i = 0; i < c.pixels->count(); i += P::width, slot += P::width) {
            const I x = load<I>(&c.pixels->x[size_t(i)]), y = load<I>(&c.pixels->y[size_t(i)]);
            const SampleSet<F> set{sample_key<U>(w.sampling.seed, w.sampling.frame, std::uint32_t(replicate_of(sample)),
                                                 num_cast<U>(x), num_cast<U>(y)),
                                   U(index_in_replicate(sample))};
            const PathStart<Real> path = start_path(w, set, {num_cast<R>(x), num_cast<R>(y)});
            if (w.features.moving_camera) view = view_at(w.camera, num_cast<R>(path.time));
            const CameraRay<R> ray = make_ray(w, view, set, path);
            store3(ray.o, b.o, slot);
            store3(ray.d, b.d, slot);
            store(path.time, b.time.at(slot));
            store(I(start::none), b.start.at(slot));
            const auto inside = x < I(w.camera.film.width) && y < I(w.camera.film.height);
            store(select(inside, iota<I>() + slot, I(-1)), b.slot.at(slot));
            store(set.key, b.key.at(slot));
            store(set.index, b.index.at(slot));
            store_color(Color3<F>(path.weight), b.throughput, slot);
            store(F(0), b.footprint.at(slot));
            store(F(pixel_spread), b.spread.at(slot));
            store_color(Color3<F>(F(0)), b.radiance, slot);
            store(F(0), b.alpha.at(slot));
        }
    }
    b.count = slot;
    b.bounce = 0;
    std::fill(b.media_count.begin(), b.media_count.end(), 0);
    c.counters->camera_rays += std::uint64_t(c.pixels->valid_count) * std::uint64_t(c.samples);
}

template void generate_stage(StageContext<float>&);
template void generate_stage(StageContext<double>&);

}  // namespace drt
