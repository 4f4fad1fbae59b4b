#pragma once
// The one room that knows Embree: nearest hits and visibility of ray packets. Infinite planes, which have no bounds,
// are tested before the BVH and shorten the ray; everything else is SIMD user geometry inside it.

#include <cstdint>
#include <memory>

#include "drt/geometry/body_table.h"

namespace drt {

inline constexpr int no_body = -1;

/// A packet of rays of the machine's width. `d` is a unit vector, so distances are lengths.
template <class Real>
struct RayPacket {
    using P = Pack<Real>;
    Vec3<typename P::R> o, d;
    typename P::R tmax;   ///< infinity for nearest-hit queries
    typename P::F time;   ///< in [0, 1]
    typename P::I start;  ///< start::pack(...) or start::none
    typename P::Mask active;
};

template <class Real>
struct HitPacket {
    using P = Pack<Real>;
    typename P::R t;
    Vec3<typename P::R> ng;  ///< outward; length is radius for spheres, 1 otherwise
    typename P::I body;      ///< no_body = nothing hit
    typename P::I part;
};

/// Rays that were not traced because Embree must not see them (non-finite, too large, not a unit direction). They
/// count as misses; the renderer reports them.
struct TraceCounters {
    std::uint64_t rejected = 0;
};

template <class Real>
class Accel {
public:
    /// Builds the BVH. `table` must outlive the Accel. Throws Error (memory, scene).
    explicit Accel(const BodyTable<Real>& table);
    ~Accel();
    Accel(Accel&&) noexcept;
    Accel& operator=(Accel&&) noexcept;

    /// Nearest hit. Equal distances (within rounding) go to the lower body id, whatever the order of traversal.
    void intersect(const RayPacket<Real>&, HitPacket<Real>&, TraceCounters&) const;

    /// Which active rays meet any body before tmax. Body `exclude` (per lane) does not block: the light's own.
    typename Pack<Real>::Mask occluded(const RayPacket<Real>&, const typename Pack<Real>::I& exclude,
                                       TraceCounters&) const;

    /// Bytes that Embree holds for this scene.
    std::size_t memory() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drt
