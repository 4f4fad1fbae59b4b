#include <limits>

#include "drt/stages/media.h"
#include "drt/stages/stages.h"

namespace drt {

namespace {

// Nearest hits of the active rays of packet i, into the batch.
template <class Real>
[[gnu::always_inline]] inline void trace_packet(StageContext<Real>& c, int i, const typename Pack<Real>::Mask& active,
                                                const Departures<Real>* from) {
    using P = Pack<Real>;
    using R = typename P::R;
    using F = typename P::F;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    const RayPacket<Real> rays{load3<R>(b.o, i),
                               load3<R>(b.d, i),
                               R(std::numeric_limits<Real>::infinity()),
                               load<F>(b.time.at(i)),
                               load<I>(b.start.at(i)),
                               active,
                               from,
                               i};
    HitPacket<Real> hits;
    c.world->accel->intersect(rays, hits, c.counters->trace);
    store(hits.t, b.t.at(i));
    store3(hits.ng, b.ng, i);
    store(select(mask_cast<I>(active), hits.body, I(no_body)), b.body.at(i));
    store(hits.part, b.part.at(i));
}

// Whether ray i has met a surface that does not exist for its path. If so, the path has crossed it, and the ray starts
// anew there.
template <class Real>
bool passes_through(StageContext<Real>& c, int i) {
    RayBatch<Real>& b = *c.batch;
    const std::vector<ContactRole>& roles = c.world->bodies.roles;
    const int body = b.body[i];
    if (body < 0 || !roles[size_t(body)].refracts) return false;
    const Vec3<Real> d{b.d.x[i], b.d.y[i], b.d.z[i]};
    const bool entering = dot(d, Vec3<Real>{b.ng.x[i], b.ng.y[i], b.ng.z[i]}) < 0;
    MediaStack<Real> stack(b, b.slot[i]);
    if (interface_at<Real>(stack, body, entering, roles).exists) return false;
    if (!cross<Real>(stack, body, entering, roles)) ++c.counters->media_overflows;
    const Real t = b.t[i];
    b.o.x[i] += d.x * t, b.o.y[i] += d.y * t, b.o.z[i] += d.z * t;
    const Departures<Real> rays = departures_of_rays(b);
    const Arrival<Real> arrival = arrival_at<Real>(departures_of_shadow_rays(b, rays), i,
                                                   largest_coordinate(Vec3<Real>{b.o.x[i], b.o.y[i], b.o.z[i]}));
    b.arrival.x[i] = arrival.d.x, b.arrival.y[i] = arrival.d.y, b.arrival.z[i] = arrival.d.z;
    b.travelled[i] = arrival.travelled;
    b.came_from[i] = arrival.came_from;
    b.start[i] = start::pack(body, b.part[i], entering ? 0 : 1);
    b.footprint[i] += b.spread[i] * float(t);
    if (c.world->features.lobe_lights) b.lobe.passed[i] += float(t);
    return true;
}

// Only the rays that passed through a surface are traced again; what the others hit is kept.
template <class Real>
void pass_through_surfaces(StageContext<Real>& c, int i, const Departures<Real>& from) {
    using P = Pack<Real>;
    using R = typename P::R;
    using I = typename P::I;
    RayBatch<Real>& b = *c.batch;
    // A path that could not remember what it entered may find no way on: then the surface is there after all.
    constexpr int most_passes = 4 * most_media;
    for (int pass = 0; pass < most_passes; ++pass) {
        typename P::Mask passing(false);
        for (int l = 0; l < P::width; ++l) passing[l] = passes_through(c, i + l);
        if (!any(passing)) return;
        const R t = load<R>(b.t.at(i));
        const Vec3<R> ng = load3<R>(b.ng, i);
        const I body = load<I>(b.body.at(i)), part = load<I>(b.part.at(i));
        trace_packet(c, i, passing, &from);
        store(select(mask_cast<R>(passing), load<R>(b.t.at(i)), t), b.t.at(i));
        store3(select(mask_cast<R>(passing), load3<R>(b.ng, i), ng), b.ng, i);
        store(select(mask_cast<I>(passing), load<I>(b.body.at(i)), body), b.body.at(i));
        store(select(mask_cast<I>(passing), load<I>(b.part.at(i)), part), b.part.at(i));
    }
}

}  // namespace

template <class Real>
void intersect_stage(StageContext<Real>& c) {
    using P = Pack<Real>;
    using F = typename P::F;
    using I = typename P::I;
    const RayBatch<Real>& b = *c.batch;
    const Departures<Real> from = departures_of_rays(b);
    for (int i = 0; i < b.count; i += P::width) {
        trace_packet(c, i, mask_cast<F>(load<I>(b.slot.at(i)) >= I(0)), b.bounce > 0 ? &from : nullptr);
        if (c.world->features.nested_media) pass_through_surfaces(c, i, from);
    }
}

template void intersect_stage(StageContext<float>&);
template void intersect_stage(StageContext<double>&);

}  // namespace drt
