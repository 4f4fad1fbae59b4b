#pragma once
// The one room that knows Embree: nearest hits and visibility of ray packets. Infinite planes, which have no bounds,
// are tested before the BVH and shorten the ray; everything else is SIMD user geometry inside it.

#include <cstdint>
#include <limits>
#include <memory>

#include "drt/geometry/body_table.h"

namespace drt {

inline constexpr int no_body = -1;

/// The media that paths are inside of: bodies that refract, by path (slot). Column k holds every path's k-th body, the
/// one that owns the others (lowest rank) on top.
struct PathMedia {
    const std::int32_t* bodies = nullptr;
    const std::int32_t* counts = nullptr;  ///< null: nothing refracts
    std::ptrdiff_t stride = 0;             ///< from column to column
    bool holds(int slot, int body) const {
        for (int k = 0; k < counts[slot]; ++k)
            if (bodies[k * stride + slot] == body) return true;
        return false;
    }
    /// no_body in vacuum.
    int owner(int slot) const { return counts[slot] > 0 ? bodies[(counts[slot] - 1) * stride + slot] : no_body; }
};

/// How the paths came to the points on surfaces where the rays of a batch start; columns by ray number. Hops from one
/// surface to another within rounding do not count: the path is still where it was, and on the same side of all that
/// meets there.
template <class Real>
struct Departures {
    const Real *dx, *dy, *dz;            ///< unit direction in which the path arrived
    const Real* travelled;               ///< distance that it came
    const std::int32_t* came_from;       ///< where the arriving ray started: start::pack(...) or start::none
    const std::int32_t* slot;            ///< the path
    PathMedia media;                     ///< on the side from which the ray leaves
    const Departures* before = nullptr;  ///< if not null: how the arriving rays departed, for those that made but a hop
};

/// One row of Departures, hops taken out of it.
template <class T>
struct Arrival {
    Vec3<T> d;
    T travelled;
    Rebind<T, int> came_from;
};

/// Rays from these points, relative to their coordinates and the way to them, are within rounding this much shorter
/// than any that leads from one place to another.
template <class Real>
inline constexpr Real hop_error = 64 * std::numeric_limits<Real>::epsilon();

template <class T>
[[gnu::always_inline]] inline T largest_coordinate(const Vec3<T>& p) {
    using std::abs;
    return max(abs(p.x), max(abs(p.y), abs(p.z)));
}

/// The arriving ray of length `t`, to a point with coordinates up to `reach`, after the way `travelled` to its start.
template <class T>
[[gnu::always_inline]] inline MaskOf<T> is_hop(const T& t, const Rebind<T, int>& started, const T& reach,
                                               const T& travelled) {
    return mask_cast<T>(started >= Rebind<T, int>(0)) && t < (reach + travelled) * T(hop_error<ScalarOf<T>>);
}

template <class T>
[[gnu::always_inline]] inline Arrival<T> arrival_at(const Departures<ScalarOf<T>>& from, int number, const T& reach) {
    using I = Rebind<T, int>;
    const auto column = [&](const Departures<ScalarOf<T>>& c) {
        return Arrival<T>{{load<T>(c.dx + number), load<T>(c.dy + number), load<T>(c.dz + number)},
                          load<T>(c.travelled + number),
                          load<I>(c.came_from + number)};
    };
    const Arrival<T> last = column(from);
    if (!from.before) return last;
    const Arrival<T> before = column(*from.before);
    const auto hop = is_hop(last.travelled, last.came_from, reach, before.travelled);
    return {select(hop, before.d, last.d), select(hop, T(before.travelled + last.travelled), last.travelled),
            last.came_from};
}

/// A packet of rays of the machine's width. `d` is a unit vector, so distances are lengths.
template <class Real>
struct RayPacket {
    using P = Pack<Real>;
    Vec3<typename P::R> o, d;
    typename P::R tmax;   ///< infinity for nearest-hit queries
    typename P::F time;   ///< in [0, 1]
    typename P::I start;  ///< start::pack(...) or start::none
    typename P::Mask active;
    const Departures<Real>* from = nullptr;  ///< null: all rays start freely, away from surfaces
    int number = 0;                          ///< of the first ray in the columns of `from`
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

    /// Nearest hit; of surfaces in contact, the one that is met first (order.h), whatever the order of traversal.
    void intersect(const RayPacket<Real>&, HitPacket<Real>&, TraceCounters&) const;

    /// Which active rays meet any body before tmax. Body `exclude` (per lane) does not block: the light's own. Nor does
    /// a surface that touches the end of the ray, nor one that does not exist because a medium of lower rank owns the
    /// place.
    typename Pack<Real>::Mask occluded(const RayPacket<Real>&, const typename Pack<Real>::I& exclude,
                                       TraceCounters&) const;

    /// Bytes that Embree holds for this scene.
    std::size_t memory() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace drt
