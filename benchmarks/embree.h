#pragma once
// Queries to Embree 3 and 4 alike: version 3 takes a context before the rays, version 4 arguments behind them.

#if DRT_EMBREE_MAJOR >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace drt {

/// How rays are to be traced: what Embree itself starts with, or told that neighbours go the same way.
class Traversal {
public:
    explicit Traversal(bool coherent);

    void nearest(RTCScene, RTCRayHit&);
    void any(RTCScene, RTCRay&);

    /// `query` is a packet query of Embree, by whatever name.
    template <class Query, class Rays>
    void nearest(Query* query, const int* valid, RTCScene, Rays&);
    template <class Query, class Rays>
    void any(Query* query, const int* valid, RTCScene, Rays&);

private:
#if DRT_EMBREE_MAJOR >= 4
    RTCIntersectArguments nearest_;
    RTCOccludedArguments any_;
#else
    RTCIntersectContext context_;
#endif
};

#if DRT_EMBREE_MAJOR >= 4

inline Traversal::Traversal(bool coherent) {
    rtcInitIntersectArguments(&nearest_);
    rtcInitOccludedArguments(&any_);
    if (coherent) nearest_.flags = any_.flags = RTC_RAY_QUERY_FLAG_COHERENT;
}

inline void Traversal::nearest(RTCScene scene, RTCRayHit& r) { rtcIntersect1(scene, &r, &nearest_); }
inline void Traversal::any(RTCScene scene, RTCRay& r) { rtcOccluded1(scene, &r, &any_); }

template <class Query, class Rays>
void Traversal::nearest(Query* query, const int* valid, RTCScene scene, Rays& r) {
    query(valid, scene, &r, &nearest_);
}

template <class Query, class Rays>
void Traversal::any(Query* query, const int* valid, RTCScene scene, Rays& r) {
    query(valid, scene, &r, &any_);
}

#else

inline Traversal::Traversal(bool coherent) {
    rtcInitIntersectContext(&context_);
    if (coherent) context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
}

inline void Traversal::nearest(RTCScene scene, RTCRayHit& r) { rtcIntersect1(scene, &context_, &r); }
inline void Traversal::any(RTCScene scene, RTCRay& r) { rtcOccluded1(scene, &context_, &r); }

template <class Query, class Rays>
void Traversal::nearest(Query* query, const int* valid, RTCScene scene, Rays& r) {
    query(valid, scene, &context_, &r);
}

template <class Query, class Rays>
void Traversal::any(Query* query, const int* valid, RTCScene scene, Rays& r) {
    query(valid, scene, &context_, &r);
}

#endif

}  // namespace drt
