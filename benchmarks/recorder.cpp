#include "recorder.h"

#include <cstring>

namespace {

std::vector<drt::RecordedPacket>* recording = nullptr;

template <class Ray>
[[maybe_unused]] void record(const int* valid, const Ray& r, bool shadow) {
    drt::RecordedPacket p;
    std::memcpy(p.valid, valid, sizeof(p.valid));
    std::memcpy(p.org[0], r.org_x, sizeof(p.org[0]));
    std::memcpy(p.org[1], r.org_y, sizeof(p.org[1]));
    std::memcpy(p.org[2], r.org_z, sizeof(p.org[2]));
    std::memcpy(p.dir[0], r.dir_x, sizeof(p.dir[0]));
    std::memcpy(p.dir[1], r.dir_y, sizeof(p.dir[1]));
    std::memcpy(p.dir[2], r.dir_z, sizeof(p.dir[2]));
    std::memcpy(p.tfar, r.tfar, sizeof(p.tfar));
    std::memcpy(p.time, r.time, sizeof(p.time));
    p.shadow = shadow;
    recording->push_back(p);
}

template <class Ray>
void restore(const drt::RecordedPacket& p, Ray& r) {
    std::memcpy(r.org_x, p.org[0], sizeof(p.org[0]));
    std::memcpy(r.org_y, p.org[1], sizeof(p.org[1]));
    std::memcpy(r.org_z, p.org[2], sizeof(p.org[2]));
    std::memcpy(r.dir_x, p.dir[0], sizeof(p.dir[0]));
    std::memcpy(r.dir_y, p.dir[1], sizeof(p.dir[1]));
    std::memcpy(r.dir_z, p.dir[2], sizeof(p.dir[2]));
    std::memcpy(r.tfar, p.tfar, sizeof(p.tfar));
    std::memcpy(r.time, p.time, sizeof(p.time));
    for (int i = 0; i < drt::packet_width; ++i) {
        r.tnear[i] = 1e-4f;  // no start primitive here: an epsilon keeps rays off their own surface
        r.mask[i] = ~0u;
        r.id[i] = unsigned(i);
        r.flags[i] = 0;
    }
}

}  // namespace

#if DRT_EMBREE_MAJOR >= 4
#define DRT_PARAMETERS(Rays, Arguments) const int *valid, RTCScene scene, Rays *rays, Arguments *arguments
#define DRT_PASS_ON valid, scene, rays, arguments
#else
#define DRT_PARAMETERS(Rays, Arguments) const int *valid, RTCScene scene, RTCIntersectContext *context, Rays *rays
#define DRT_PASS_ON valid, scene, context, rays
#endif

// A wrapper for each packet width; the renderer uses one of them with float geometry, and that one is recorded.
#define DRT_WRAP(width)                                                                        \
    extern "C" {                                                                               \
    decltype(rtcIntersect##width) __real_rtcIntersect##width;                                  \
    decltype(rtcOccluded##width) __real_rtcOccluded##width;                                    \
    void __wrap_rtcIntersect##width(DRT_PARAMETERS(RTCRayHit##width, RTCIntersectArguments)) { \
        if constexpr (drt::packet_width == width)                                              \
            if (recording) record(valid, rays->ray, false);                                    \
        __real_rtcIntersect##width(DRT_PASS_ON);                                               \
    }                                                                                          \
    void __wrap_rtcOccluded##width(DRT_PARAMETERS(RTCRay##width, RTCOccludedArguments)) {      \
        if constexpr (drt::packet_width == width)                                              \
            if (recording) record(valid, *rays, true);                                         \
        __real_rtcOccluded##width(DRT_PASS_ON);                                                \
    }                                                                                          \
    }
DRT_WRAP(4)
DRT_WRAP(8)
DRT_WRAP(16)
#undef DRT_WRAP
#undef DRT_PARAMETERS
#undef DRT_PASS_ON

namespace {

template <int width>
struct Embree;
template <>
struct Embree<4> {
    using RayHit = RTCRayHit4;
    using Ray = RTCRay4;
    static constexpr auto intersect = __real_rtcIntersect4;
    static constexpr auto occluded = __real_rtcOccluded4;
};
template <>
struct Embree<8> {
    using RayHit = RTCRayHit8;
    using Ray = RTCRay8;
    static constexpr auto intersect = __real_rtcIntersect8;
    static constexpr auto occluded = __real_rtcOccluded8;
};
template <>
struct Embree<16> {
    using RayHit = RTCRayHit16;
    using Ray = RTCRay16;
    static constexpr auto intersect = __real_rtcIntersect16;
    static constexpr auto occluded = __real_rtcOccluded16;
};
using Native = Embree<drt::packet_width>;

}  // namespace

namespace drt {

void start_recording(std::vector<RecordedPacket>& into) { recording = &into; }
void stop_recording() { recording = nullptr; }

std::size_t replay(const BareScene& scene, const std::vector<RecordedPacket>& packets) {
    Traversal traversal(false);
    std::size_t hits = 0;
    for (const RecordedPacket& p : packets) {
        if (p.shadow) {
            alignas(64) Native::Ray r;
            restore(p, r);
            traversal.any(Native::occluded, p.valid, scene.scene, r);
            for (int i = 0; i < packet_width; ++i) hits += p.valid[i] != 0 && r.tfar[i] < 0;
        } else {
            alignas(64) Native::RayHit r;
            restore(p, r.ray);
            for (int i = 0; i < packet_width; ++i) r.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            traversal.nearest(Native::intersect, p.valid, scene.scene, r);
            for (int i = 0; i < packet_width; ++i)
                hits += p.valid[i] != 0 && r.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
        }
    }
    return hits;
}

}  // namespace drt
