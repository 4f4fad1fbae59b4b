#include "drt/accel/accel.h"

#include <fmt/format.h>
#if DRT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "drt/accel/query.h"
#include "drt/base/diagnostic.h"
#include "drt/base/task_order.h"

namespace drt {

namespace {

using namespace accel_detail;

// Coordinates above this make Debian's Embree 3.13.5 abort.
constexpr double embree_limit = 1e18;

// ---- Embree 3 and 4, packets of 4, 8 and 16 rays -------------------------------------------------------------------

// Embree 4 renamed the context of a query and moved it into a struct of arguments.
#if DRT_EMBREE_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
constexpr auto init_context = rtcInitRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
constexpr auto init_context = rtcInitIntersectContext;
#endif

template <int width>
struct EmbreePacket;
template <>
struct EmbreePacket<4> {
    using RayHit = RTCRayHit4;
    using Ray = RTCRay4;
    static constexpr auto intersect = rtcIntersect4;
    static constexpr auto occluded = rtcOccluded4;
};
template <>
struct EmbreePacket<8> {
    using RayHit = RTCRayHit8;
    using Ray = RTCRay8;
    static constexpr auto intersect = rtcIntersect8;
    static constexpr auto occluded = rtcOccluded8;
};
template <>
struct EmbreePacket<16> {
    using RayHit = RTCRayHit16;
    using Ray = RTCRay16;
    static constexpr auto intersect = rtcIntersect16;
    static constexpr auto occluded = rtcOccluded16;
};

template <int width>
void embree_intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                      typename EmbreePacket<width>::RayHit& rays) {
#if DRT_EMBREE_MAJOR >= 4
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    EmbreePacket<width>::intersect(valid, scene, &rays, &arguments);
#else
    EmbreePacket<width>::intersect(valid, scene, &context, &rays);
#endif
}

template <int width>
void embree_occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                     typename EmbreePacket<width>::Ray& rays) {
#if DRT_EMBREE_MAJOR >= 4
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    EmbreePacket<width>::occluded(valid, scene, &rays, &arguments);
#else
    EmbreePacket<width>::occluded(valid, scene, &context, &rays);
#endif
}

// ---- callbacks ------------------------------------------------------------------------------------------------------

// What a callback finds behind Embree's context pointer. Embree's own float copy of the rays only steers the traversal.
template <class Real>
struct EmbreeQuery {
    EmbreeContext embree;
    Query<Real> query;
};

template <class Real>
Query<Real>& query_of(EmbreeContext* context) {
    return reinterpret_cast<EmbreeQuery<Real>*>(context)->query;
}

// Embree culls by its float tfar: a little beyond the true distance, so that ties still reach the callback.
template <class T>
[[gnu::always_inline]] inline Rebind<T, float> culling_distance(const T& t) {
    constexpr float slack = 1 + 8 * std::numeric_limits<float>::epsilon();
    return num_cast<Rebind<T, float>>(t) * Rebind<T, float>(slack);
}

template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask valid_lanes(const int* valid) {
    using I = typename Pack<Real>::I;
    return mask_cast<typename Pack<Real>::F>(load<I>(valid) != I(0));
}

template <ShapeKind kind, bool moving, class Real>
void intersect_callback(const RTCIntersectFunctionNArguments* args) {
    using P = Pack<Real>;
    const auto& g = *static_cast<const Group<Real>*>(args->geometryUserPtr);
    Query<Real>& q = query_of<Real>(args->context);
    const int body = g.group.first + int(args->primID);
    RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, args->N);
    RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, args->N);
    if (args->N == unsigned(P::width)) {
        const auto candidates = valid_lanes<Real>(args->valid) && may_hit<kind>(q, body);
        if (!any(candidates)) return;
        const auto took = nearest_in_lanes<kind, moving>(g, body, q, candidates);
        if (!any(took)) return;
        using F = typename P::F;
        using U = typename P::U;
        float* tfar = &RTCRayN_tfar(ray, args->N, 0);
        store(select(took, culling_distance(q.hits->t), load<F>(tfar)), tfar);
        unsigned* geom = &RTCHitN_geomID(hit, args->N, 0);
        store(select(mask_cast<U>(took), U(args->geomID), load<U>(geom)), geom);
        return;
    }
    // Embree fell back to single rays: find each one's lane by its id.
    for (unsigned i = 0; i < args->N; ++i) {
        if (!args->valid[i]) continue;
        const int l = int(RTCRayN_id(ray, args->N, i));
        if (!nearest_in_lane<kind, moving>(g, body, q, l)) continue;
        RTCRayN_tfar(ray, args->N, i) = culling_distance(lane(q.hits->t, l));
        RTCHitN_geomID(hit, args->N, i) = args->geomID;
    }
}

template <ShapeKind kind, bool moving, class Real>
void occluded_callback(const RTCOccludedFunctionNArguments* args) {
    using P = Pack<Real>;
    const auto& g = *static_cast<const Group<Real>*>(args->geometryUserPtr);
    Query<Real>& q = query_of<Real>(args->context);
    const int body = g.group.first + int(args->primID);
    constexpr float blocked = -std::numeric_limits<float>::infinity();
    if (args->N == unsigned(P::width)) {
        using F = typename P::F;
        const auto candidates = valid_lanes<Real>(args->valid) && may_hit<kind>(q, body);
        if (!any(candidates)) return;
        const auto hits = blocked_lanes<kind, moving>(g, body, q) && candidates;
        if (!any(hits)) return;
        float* tfar = &RTCRayN_tfar(args->ray, args->N, 0);
        store(select(hits, F(blocked), load<F>(tfar)), tfar);
        return;
    }
    for (unsigned i = 0; i < args->N; ++i) {
        if (!args->valid[i]) continue;
        const int l = int(RTCRayN_id(args->ray, args->N, i));
        if (blocked_lane<kind, moving>(g, body, q, l)) RTCRayN_tfar(args->ray, args->N, i) = blocked;
    }
}

// ---- queries --------------------------------------------------------------------------------------------------------

template <class Real, class EmbreeRay>
[[gnu::always_inline]] inline void fill_ray(EmbreeRay& e, const RayPacket<Real>& r,
                                            const typename Pack<Real>::R& tmax) {
    using F = typename Pack<Real>::F;
    using U = typename Pack<Real>::U;
    store(num_cast<F>(r.o.x), e.org_x);
    store(num_cast<F>(r.o.y), e.org_y);
    store(num_cast<F>(r.o.z), e.org_z);
    store(num_cast<F>(r.d.x), e.dir_x);
    store(num_cast<F>(r.d.y), e.dir_y);
    store(num_cast<F>(r.d.z), e.dir_z);
    store(F(0), e.tnear);
    store(culling_distance(tmax), e.tfar);
    store(r.time, e.time);
    store(U(~0u), e.mask);
    store(iota<U>(), e.id);
    store(U(0), e.flags);
}

// Embree aborts the process on rays like these; a NaN fails every comparison.
template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask traceable(const RayPacket<Real>& r) {
    using R = typename Pack<Real>::R;
    using F = typename Pack<Real>::F;
    using std::abs;
    const R limit(Real{embree_limit});
    const R d2 = dot(r.d, r.d);
    // each coordinate by itself: a maximum of them may drop a NaN
    const auto origin_ok = abs(r.o.x) <= limit && abs(r.o.y) <= limit && abs(r.o.z) <= limit;
    return mask_cast<F>(origin_ok && d2 > R(Real(0.99)) && d2 < R(Real(1.01)) && r.tmax >= R(0)) && r.time >= F(0) &&
           r.time <= F(1);
}

template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::R slack_of(const RayPacket<Real>& r) {
    using R = typename Pack<Real>::R;
    const R reach = largest_coordinate(r.o);
    R travelled(0);
    if (r.from) travelled = load<R>(r.from->travelled + r.number);
    if (r.from && r.from->before)
        travelled += load<R>(r.from->before->travelled + r.number);  // only counts after a hop
    return (reach + travelled) * R(origin_error<Real>);
}

template <class Real>
[[gnu::always_inline]] inline typename Pack<Real>::Mask reject_bad(const RayPacket<Real>& r, TraceCounters& counters) {
    const auto ok = traceable(r);
    if (const auto bad = r.active && !ok; any(bad)) counters.rejected += std::uint64_t(count(bad));
    return r.active && ok;
}

void throw_embree_error(RTCError code, const std::string& text) {
    throw Error(code == RTC_ERROR_OUT_OF_MEMORY ? ErrorKind::memory : ErrorKind::internal,
                fmt::format("Embree: {} (code {})", text, int(code)));
}

}  // namespace

template <class Real>
struct Accel<Real>::Impl {
    const BodyTable<Real>* table;
    std::vector<std::unique_ptr<Group<Real>>> groups;  // stable addresses: Embree keeps pointers
    Group<Real> planes;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::atomic<std::ptrdiff_t> bytes{0};
    bool empty = true;

    explicit Impl(const BodyTable<Real>& t) : table(&t), planes{&t, t.plane_group} {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;
    ~Impl() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    void check() const {
        const RTCError code = rtcGetDeviceError(device);
        if (code != RTC_ERROR_NONE) throw_embree_error(code, "cannot build the acceleration structure");
    }

    template <ShapeKind kind, bool moving>
    static void set_callbacks(RTCGeometry geometry) {
        rtcSetGeometryIntersectFunction(geometry, intersect_callback<kind, moving, Real>);
        rtcSetGeometryOccludedFunction(geometry, occluded_callback<kind, moving, Real>);
    }

    template <ShapeKind kind>
    static void set_callbacks(RTCGeometry geometry, bool moving) {
        moving ? set_callbacks<kind, true>(geometry) : set_callbacks<kind, false>(geometry);
    }

    void add_group(const BodyGroup& group);
    void build();
};

namespace {

// Bounds rounded outward to float. No ray may lose a body whose bounds it touches, and only the margin sees to that:
// Embree walks user geometry with its fast, not its robust, box test, whatever the scene's flags say (3.13 and 4: the
// BVH*Virtual* intersectors are made with robust = false). That test, too, errs by a few roundings of float only. The
// margin is for rays whose float copy, which walks the BVH, passes beside the true one: by 2.4e-7 of the length
// travelled from far away (so a body is exact seen from 10^4 times its size, all that float scenes have), and by the
// rounding of coordinates from close by.
float round_down(double v) { return std::nextafter(float(v), -std::numeric_limits<float>::infinity()); }
float round_up(double v) { return std::nextafter(float(v), std::numeric_limits<float>::infinity()); }

RTCBounds to_embree(const Bounds& b) {
    const double margin = 1e-3 * length(b.upper - b.lower) + 2.5e-7 * (length(b.lower) + length(b.upper));
    RTCBounds out{};
    out.lower_x = round_down(b.lower.x - margin);
    out.lower_y = round_down(b.lower.y - margin);
    out.lower_z = round_down(b.lower.z - margin);
    out.upper_x = round_up(b.upper.x + margin);
    out.upper_y = round_up(b.upper.y + margin);
    out.upper_z = round_up(b.upper.z + margin);
    return out;
}

template <class Real>
void bounds_callback(const RTCBoundsFunctionArguments* args) {
    const task_order::Task order;
    const auto& g = *static_cast<const Group<Real>*>(args->geometryUserPtr);
    const auto all = body_bounds(*g.table, g.group, g.group.first + int(args->primID));
    *args->bounds_o = to_embree(all[std::min(size_t(args->timeStep), all.size() - 1)]);
}

}  // namespace

template <class Real>
void Accel<Real>::Impl::add_group(const BodyGroup& group) {
    groups.push_back(std::make_unique<Group<Real>>(Group<Real>{table, group}));
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(group.count));
    rtcSetGeometryUserData(geometry, groups.back().get());
    rtcSetGeometryTimeStepCount(geometry, unsigned(group.time_steps));
    rtcSetGeometryBoundsFunction(geometry, bounds_callback<Real>, nullptr);
    switch (group.kind) {
        case ShapeKind::sphere:
            set_callbacks<ShapeKind::sphere>(geometry, group.moving);
            break;
        case ShapeKind::flat:
            set_callbacks<ShapeKind::flat>(geometry, group.moving);
            break;
        case ShapeKind::box:
            set_callbacks<ShapeKind::box>(geometry, group.moving);
            break;
        case ShapeKind::cylinder:
            set_callbacks<ShapeKind::cylinder>(geometry, group.moving);
            break;
        case ShapeKind::plane:
            break;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    check();
}

template <class Real>
void Accel<Real>::Impl::build() {
    if (table->groups.empty()) return;
    device = rtcNewDevice(nullptr);
    if (!device) throw_embree_error(rtcGetDeviceError(nullptr), "cannot create a device");
    rtcSetDeviceMemoryMonitorFunction(
        device,
        [](void* user, ssize_t change, bool) {
            static_cast<std::atomic<std::ptrdiff_t>*>(user)->fetch_add(change);
            return true;
        },
        &bytes);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);  // without effect on user geometry: see to_embree
    for (const BodyGroup& g : table->groups) add_group(g);
    task_order::before_loop();
    rtcCommitScene(scene);
    task_order::after_loop();
    check();
    empty = false;
}

template <class Real>
Accel<Real>::Accel(const BodyTable<Real>& table) : impl_(std::make_unique<Impl>(table)) {
    impl_->build();
}
template <class Real>
Accel<Real>::~Accel() = default;
template <class Real>
Accel<Real>::Accel(Accel&&) noexcept = default;
template <class Real>
Accel<Real>& Accel<Real>::operator=(Accel&&) noexcept = default;

template <class Real>
void Accel<Real>::intersect(const RayPacket<Real>& rays, HitPacket<Real>& hits, TraceCounters& counters) const {
    using P = Pack<Real>;
    using I = typename P::I;
    using Embree = EmbreePacket<P::width>;
    const auto active = reject_bad(rays, counters);
    hits.t = rays.tmax;
    hits.body = I(no_body);
    EmbreeQuery<Real> embree;
    init_context(&embree.embree);
    Query<Real>& q = embree.query;
    q.rays = &rays;
    q.hits = &hits;
    q.slack = slack_of(rays);
    q.hit_error = typename P::R(0);
    if (impl_->planes.group.count > 0) intersect_planes(impl_->planes, q, active);
    if (!impl_->empty && any(active)) {
        alignas(64) typename Embree::RayHit e;
        alignas(64) int valid[P::width];
        fill_ray(e.ray, rays, hits.t);
        store(typename P::U(RTC_INVALID_GEOMETRY_ID), e.hit.geomID);
        store(select(mask_cast<I>(active), I(-1), I(0)), valid);
        embree_intersect<P::width>(valid, impl_->scene, embree.embree, e);
    }
}

template <class Real>
typename Pack<Real>::Mask Accel<Real>::occluded(const RayPacket<Real>& rays, const typename Pack<Real>::I& exclude,
                                                TraceCounters& counters) const {
    using P = Pack<Real>;
    using F = typename P::F;
    using I = typename P::I;
    using Embree = EmbreePacket<P::width>;
    auto active = reject_bad(rays, counters);
    EmbreeQuery<Real> embree;
    init_context(&embree.embree);
    Query<Real>& q = embree.query;
    q.rays = &rays;
    q.slack = slack_of(rays);
    q.exclude = exclude;
    typename P::Mask blocked(false);
    if (impl_->planes.group.count > 0) {
        blocked = occluded_by_planes(impl_->planes, q, active);
        active = active && !blocked;
    }
    if (!impl_->empty && any(active)) {
        alignas(64) typename Embree::Ray e;
        alignas(64) int valid[P::width];
        fill_ray(e, rays, rays.tmax);
        store(select(mask_cast<I>(active), I(-1), I(0)), valid);
        embree_occluded<P::width>(valid, impl_->scene, embree.embree, e);
        blocked = blocked || (active && load<F>(e.tfar) < F(0));
    }
    return blocked;
}

template <class Real>
std::size_t Accel<Real>::memory() const {
    return std::size_t(std::max<std::ptrdiff_t>(0, impl_->bytes.load()));
}

template class Accel<float>;
template class Accel<double>;

}  // namespace drt
