#pragma once
// One batch: the rays of a tile for a few samples, as a structure of arrays that stays in the second-level cache and
// is reused. Stages read and write it; nothing here allocates after construction.

#include <array>
#include <cstdint>
#include <vector>

#include "drt/accel/accel.h"
#include "drt/base/color.h"
#include "drt/sampling/sampler.h"

namespace drt {

inline constexpr int batch_capacity = 2048;  ///< rays: measured, docs/pipeline.md

/// A column of the batch. Padded by one packet: stores of whole packets may run over the end.
template <class T>
struct alignas(64) Column {
    std::array<T, batch_capacity + 16> v;
    T* at(int i) { return v.data() + i; }
    const T* at(int i) const { return v.data() + i; }
    T& operator[](int i) { return v[size_t(i)]; }
    const T& operator[](int i) const { return v[size_t(i)]; }
};

template <class T>
struct Column3 {
    Column<T> x, y, z;
};

template <class V, class S>
[[gnu::always_inline]] inline Vec3<V> load3(const Column3<S>& c, int i) {
    return {load<V>(c.x.at(i)), load<V>(c.y.at(i)), load<V>(c.z.at(i))};
}
template <class V, class S>
[[gnu::always_inline]] inline Color3<V> load_color(const Column3<S>& c, int i) {
    return {load<V>(c.x.at(i)), load<V>(c.y.at(i)), load<V>(c.z.at(i))};
}
template <class V, class S>
[[gnu::always_inline]] inline void store3(const Vec3<V>& v, Column3<S>& c, int i) {
    store(v.x, c.x.at(i));
    store(v.y, c.y.at(i));
    store(v.z, c.z.at(i));
}
template <class V, class S>
[[gnu::always_inline]] inline void store_color(const Color3<V>& v, Column3<S>& c, int i) {
    store(v.r, c.x.at(i));
    store(v.g, c.y.at(i));
    store(v.b, c.z.at(i));
}

/// From the surface points towards one light each, by ray number.
template <class Real>
struct ShadowRays {
    Column<std::uint32_t> digits_x, digits_y;  ///< PointDigits that all lights of a hit share
    Column3<Real> d;
    Column<Real> distance;         ///< to the light
    Column<std::int32_t> exclude;  ///< the light's own body
    Column<float> density;         ///< of the light's samples there, per steradian; 0: no lobe could hit it
    Column3<float> light;          ///< what arrives and is reflected if nothing is in the way; 0: no ray
};

/// A light for each hit, of those that are too many to ask every one.
struct LightDraws {
    Column<std::int32_t> light;  ///< its id, or no_light
    Column<float> samples;       ///< how many are taken of it at this hit in the mean
};

/// Where a glossy reflection came from, by ray number: what a visible light that it meets is weighed with. Only kept by
/// scenes with Features::lobe_lights, from the first bounce on.
struct LobeOrigins {
    Column<float> density;  ///< of the ray's direction, per steradian; 0: no light sample could have taken it
    Column3<float> n;       ///< the normal there, on the ray's side
    Column<float> passed;   ///< length of the ray before `o`, where it passed through surfaces that do not exist
};

template <class Real>
struct RayBatch {
    // rays 0 .. count - 1, compacted after each bounce; `slot` leads back to the path
    int count = 0;
    int bounce = 0;
    Column3<Real> o, d;
    Column<float> time;  ///< 0 where nothing moves
    Column<std::int32_t> start;
    /// -1: padding, no ray. The lowest four bits are the pixel's place in its block of the film.
    Column<std::int32_t> slot;
    Column<std::uint32_t> key, index;  ///< of the path's sample
    Column<std::uint32_t> hit_index;   ///< the same at the joint slot of the next hit's lights and lobe
    Column3<float> throughput;
    Column<float> footprint, spread;  ///< of the ray's cone: width at the origin, growth per length; if textured
    // of rays that start on a surface: how the path came there (accel.h)
    Column3<Real> arrival;
    Column<Real> travelled;
    Column<std::int32_t> came_from;

    // hits
    Column<Real> t;
    Column3<Real> ng;
    Column<std::int32_t> body, part;

    // surface points of rays that hit a surface (material >= 0)
    Column3<Real> p, n;             ///< point; unit normal that faces the ray
    Column<std::int32_t> material;  ///< -1: nothing to shade
    Column<std::int32_t> outward;   ///< 1: the ray came from the side that ng points to
    Column3<float> albedo;          ///< diffuse colour, textured or not
    ShadowRays<Real> shadow;
    LobeOrigins lobe;
    std::array<LightDraws, 4> drawn;

    // paths, by slot: not compacted
    Column3<float> radiance;
    Column<float> alpha;
    std::vector<std::int32_t> media;  ///< [capacity][slot]: bodies that the path is inside of (media.h)
    std::vector<std::int32_t> media_count;

    explicit RayBatch(int media_capacity)
        : time{},
          media(size_t(media_capacity) * batch_capacity),
          media_count(media_capacity > 0 ? batch_capacity : 0) {}
};

/// The sample that ray i, or packet i, belongs to.
template <class T, class Real>
[[gnu::always_inline]] inline SampleSet<T> sample_of(const RayBatch<Real>& b, int i) {
    using U = Rebind<T, std::uint32_t>;
    const U place = num_cast<U>(load<Rebind<T, std::int32_t>>(b.slot.at(i)));
    return {load<U>(b.key.at(i)), load<U>(b.index.at(i)), pixel_offset(place)};
}

template <class Real>
PathMedia path_media(const RayBatch<Real>& b) {
    return {b.media.data(), b.media_count.empty() ? nullptr : b.media_count.data(), batch_capacity};
}

/// How the batch's rays left the surfaces where they start.
template <class Real>
Departures<Real> departures_of_rays(const RayBatch<Real>& b) {
    return {b.arrival.x.at(0), b.arrival.y.at(0), b.arrival.z.at(0), b.travelled.at(0),
            b.came_from.at(0), b.slot.at(0),      path_media(b)};
}

/// How shadow rays leave the batch's hits: the rays themselves are what arrived. `rays` is how those departed.
template <class Real>
Departures<Real> departures_of_shadow_rays(const RayBatch<Real>& b, const Departures<Real>& rays) {
    // Camera rays start freely, and so never hop; but they may start anew where they pass through a surface.
    const bool from_surfaces = b.bounce > 0 || !b.media.empty();
    return {b.d.x.at(0),   b.d.y.at(0),  b.d.z.at(0),   b.t.at(0),
            b.start.at(0), b.slot.at(0), path_media(b), from_surfaces ? &rays : nullptr};
}

}  // namespace drt
