#pragma once
// An orthonormal basis around a direction.

#include "drt/base/vec.h"

namespace drt {

template <class T>
struct Frame {
    Vec3<T> x, y, z;
    Vec3<T> to_world(const Vec3<T>& v) const { return x * v.x + y * v.y + z * v.z; }
    Vec3<T> to_local(const Vec3<T>& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
};

/// Branch-free: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017. `z` must be a unit vector.
template <class T>
[[gnu::always_inline]] inline Frame<T> frame_around(const Vec3<T>& z) {
    const T sign = select(z.z < T(0), T(-1), T(1));
    const T a = T(-1) / (sign + z.z);
    const T b = z.x * z.y * a;
    return {{T(1) + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace drt
