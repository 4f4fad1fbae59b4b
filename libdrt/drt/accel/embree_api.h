#pragma once
// What differs between Embree 3 and 4, and between packets of 4, 8 and 16 rays.

#if DRT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace drt {

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

}  // namespace drt
