#include <algorithm>
#include <bit>
#include <cmath>

#include "drt/sampling/shutter.h"
#include "drt/stages/stages.h"

namespace drt {

// In several loops, each over the whole batch: what is done for one packet is a chain in which every step waits for the
// one before, and the machine can only overlap packets that lie within some hundred instructions of each other.

namespace {

// Coordinates of the packet at pixel i of the batch's pixels.
template <class I>
[[gnu::always_inline]] inline Vec2<I> pixel_at(const BatchPixels& pixels, int i) {
    const TileBlock& block = pixels.blocks[size_t(i / block_pixels)];
    const size_t within = size_t(i % block_pixels);
    return {I(block.x) + load<I>(&block_x[within]), I(block.y) + load<I>(&block_y[within])};
}

// What a camera ray draws and the lights and lobe of its hit share a shuffled index.
static_assert(joint_slot(dim(PathDim::filter)).group == joint_slot(dim(PathDim::lens)).group &&
              joint_slot(dim(PathDim::filter)).group == joint_slot(dim(PathDim::time)).group &&
              joint_slot(dim(PathDim::filter)).group == joint_slot(hit_dim(0)).group);

// The film's blocks are those whose pixels share a key, in the order of places that have offsets (sample_of()).
constexpr bool offsets_fit_the_film() {
    for (std::uint32_t i = 0; i < block_pixels; ++i)
        if (place_in_block(std::uint32_t(block_x[i]), std::uint32_t(block_y[i])) != i) return false;
    return block_side == 1 << offset_block_bits;
}
static_assert(offsets_fit_the_film());

// Names the sample sets of packet i's pixels and draws the points of the unit square for their pixel filter, into p.x
// and p.y, which nobody needs yet: samples `first`, first + replicate_count, ..., all of one replicate, so that the
// hashes that make its key and scrambles are the same for all of them. `hit_index` holds the index as shuffled for the
// first group of dimensions until the last loop, so that the shuffle is done once.
template <SamplerKind kind, class Real>
[[gnu::always_inline]] inline void name_samples(const StageContext<Real>& c, int i, int first) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    using U = typename P::U;
    const SamplePlan& plan = c.world->sampling;
    RayBatch<Real>& b = *c.batch;
    constexpr DimId dimension = dim(PathDim::filter);
    const auto [x, y] = pixel_at<I>(c.pixels, i);
    const auto inside = x < I(c.world->camera.film.width) && y < I(c.world->camera.film.height);
    SampleSet<F> set =
        pixel_sample<F>(plan.seed, plan.frame, std::uint32_t(replicate_of(c.first_sample + std::uint32_t(first))),
                        num_cast<U>(x), num_cast<U>(y), U(0u));
    for (int s = first; s < c.samples; s += replicate_count) {
        const int slot = s * c.pixels.count() + i;
        set.index = U(index_in_replicate(c.first_sample + std::uint32_t(s)));
        const GroupSamples<F> samples = in_group(kind, set, dimension);
        store(select(inside, iota<I>() + slot, I(-1)), b.slot.at(slot));
        store(set.key, b.key.at(slot));
        store(set.index, b.index.at(slot));
        store(samples.index, b.hit_index.at(slot));
        if (!c.world->features.pixel_filter) continue;
        const Vec2<F> u = sample_2d(kind, at_slot(kind, samples, dimension), dimension);
        store(num_cast<R>(u.x), b.p.x.at(slot));
        store(num_cast<R>(u.y), b.p.y.at(slot));
    }
}

template <SamplerKind kind, class Real>
void name_all_samples(const StageContext<Real>& c) {
    for (int i = 0; i < c.pixels.count(); i += Pack<Real>::width)
        for (int first = 0; first < std::min(replicate_count, c.samples); ++first) name_samples<kind>(c, i, first);
}

template <class Real>
GroupSamples<typename Pack<Real>::F> path_samples(const RayBatch<Real>& b, int i) {
    using U = typename Pack<Real>::U;
    return {load<U>(b.key.at(i)), load<U>(b.hit_index.at(i))};
}

// Where on the film, in pixels: into p.x and p.y again. The filter's weight starts the throughput.
template <class Real>
void place_on_film(const StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    int pixel = 0;
    for (int i = 0; i < b.count; i += P::width, pixel += P::width) {
        if (pixel == c.pixels.count()) pixel = 0;
        const Vec2<I> corner = pixel_at<I>(c.pixels, pixel);
        R x = num_cast<R>(corner.x) + R(Real(0.5)), y = num_cast<R>(corner.y) + R(Real(0.5));
        F weight(1);
        if (w.features.pixel_filter) {
            const Vec2<F> u{num_cast<F>(load<R>(b.p.x.at(i))), num_cast<F>(load<R>(b.p.y.at(i)))};
            const FilterSample<F> s = sample_filter(w.filter, u);
            x += num_cast<R>(s.offset.x);
            y += num_cast<R>(s.offset.y);
            weight = s.weight;
        }
        store(x, b.p.x.at(i));
        store(y, b.p.y.at(i));
        store_color(Color3<F>(weight), b.throughput, i);
    }
}

template <class Real>
[[gnu::always_inline]] inline CameraRay<typename Pack<Real>::R> make_ray(
    const World<Real>& w, const View<typename Pack<Real>::R>& view, const Vec2<typename Pack<Real>::R>& position,
    const GroupSamples<typename Pack<Real>::F>& samples) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    if (!w.features.lens) return camera_ray<false>(view, w.camera.film, w.camera.lens, position, {});
    constexpr DimId dimension = dim(PathDim::lens);
    const Vec2<F> u = sample_2d(w.sampling.kind, at_slot(w.sampling.kind, samples, dimension), dimension);
    return camera_ray<true>(view, w.camera.film, w.camera.lens, position, {num_cast<R>(u.x), num_cast<R>(u.y)});
}

// How wide the cone of a camera ray is at distance 1: as wide as what n samples of a pixel leave between each other,
// 1 / sqrt(n) pixels, where n is not how many there will be, but how many there were until this one and its like in the
// other replicate. So pictures of few samples have no more aliasing than those are worth, and the mean converges to the
// texture as the pixel filter sees it (docs/images-and-textures.md). The cosine is of the angle to the view's axis, as
// pixels off the axis are further away. Without a filter all samples lie in one place: each stands for the whole pixel.
template <class Real>
typename Pack<Real>::F cone_spread(const StageContext<Real>& c, int sample, const typename Pack<Real>::R& pixel_size,
                                   const typename Pack<Real>::R& cosine) {
    using F = typename Pack<Real>::F;
    if (c.world->filter.spec.kind == FilterKind::point) return num_cast<F>(pixel_size);
    const float n = 2 * float(index_in_replicate(c.first_sample + std::uint32_t(sample))) + 1;
    return num_cast<F>(pixel_size * cosine) * F(1 / std::sqrt(n));
}

template <class Real>
void aim_rays(const StageContext<Real>& c) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    const World<Real>& w = *c.world;
    RayBatch<Real>& b = *c.batch;
    View<R> view = cast<R>(w.view);
    for (int i = 0; i < b.count; i += P::width) {
        const GroupSamples<F> samples = path_samples(b, i);
        F time(0);
        if (w.features.time) {
            constexpr DimId dimension = dim(PathDim::time);
            const F u = sample_1d(w.sampling.kind, at_slot(w.sampling.kind, samples, dimension), dimension);
            time = shutter_time(u, F(w.camera.switch_ratio));
        }
        if (w.features.moving_camera) view = view_at(w.camera, num_cast<R>(time));
        const CameraRay<R> ray = make_ray(w, view, {load<R>(b.p.x.at(i)), load<R>(b.p.y.at(i))}, samples);
        store3(ray.o, b.o, i);
        store3(ray.d, b.d, i);
        if (w.features.time) store(time, b.time.at(i));  // else 0, as the batch was made
        store(I(start::none), b.start.at(i));
        store(at_slot(w.sampling.kind, samples, hit_dim(0)).index, b.hit_index.at(i));
        if (!w.features.textures) continue;
        store(F(0), b.footprint.at(i));
        store(cone_spread(c, i / c.pixels.count(), view.pixel_size, dot(ray.d, view.forward)), b.spread.at(i));
    }
}

}  // namespace

template <class Real>
void generate_stage(StageContext<Real>& c) {
    RayBatch<Real>& b = *c.batch;
    // The kind is a constant within the loops: the compiler moves a hash out of a loop, but not a branch around it.
    if (c.world->sampling.kind == SamplerKind::sobol)
        name_all_samples<SamplerKind::sobol>(c);
    else
        name_all_samples<SamplerKind::independent>(c);
    b.count = c.samples * c.pixels.count();
    place_on_film(c);
    aim_rays(c);
    b.bounce = 0;
    if (!b.media.empty()) std::fill_n(b.travelled.at(0), b.count, Real(0));
    std::fill(b.media_count.begin(), b.media_count.end(), 0);
    for (const TileBlock& block : c.pixels.blocks)
        c.counters->camera_rays += std::uint64_t(std::popcount(block.valid)) * std::uint64_t(c.samples);
}

template void generate_stage(StageContext<float>&);
template void generate_stage(StageContext<double>&);

}  // namespace drt
