#include "drt/accel/accel.h"

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "drt/accel/callbacks.h"
#include "drt/base/diagnostic.h"
#include "drt/base/task_order.h"

namespace drt {

namespace {

using namespace accel_detail;

// Coordinates above this make Debian's Embree 3.13.5 abort.
constexpr double embree_limit = 1e18;

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
    Query<Real> q;
    init_context(&q.embree);
    q.rays = &rays;
    q.hits = &hits;
    q.slack = slack_of(rays);
    q.hit_error = typename P::R(0);
    intersect_planes(impl_->planes, q, active);
    if (!impl_->empty && any(active)) {
        alignas(64) typename Embree::RayHit e;
        alignas(64) int valid[P::width];
        fill_ray(e.ray, rays, hits.t);
        store(typename P::U(RTC_INVALID_GEOMETRY_ID), e.hit.geomID);
        store(select(mask_cast<I>(active), I(-1), I(0)), valid);
        embree_intersect<P::width>(valid, impl_->scene, q.embree, e);
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
    Query<Real> q;
    init_context(&q.embree);
    q.rays = &rays;
    q.slack = slack_of(rays);
    q.exclude = exclude;
    auto blocked = active && occluded_by_planes(impl_->planes, q);
    active = active && !blocked;
    if (!impl_->empty && any(active)) {
        alignas(64) typename Embree::Ray e;
        alignas(64) int valid[P::width];
        fill_ray(e, rays, rays.tmax);
        store(select(mask_cast<I>(active), I(-1), I(0)), valid);
        embree_occluded<P::width>(valid, impl_->scene, q.embree, e);
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
