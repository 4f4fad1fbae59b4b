#pragma once
// Unit quaternions as rotations, q = w + xi + yj + zk, acting v -> q v q*.

#include "drt/base/vec.h"

namespace drt {

template <class T>
struct Quat {
    T w{1}, x{0}, y{0}, z{0};

    Quat() = default;
    constexpr Quat(T w_, T x_, T y_, T z_) : w(w_), x(x_), y(y_), z(z_) {}
    template <class U>
    explicit Quat(const Quat<U>& q)
        : w(num_cast<T>(q.w)), x(num_cast<T>(q.x)), y(num_cast<T>(q.y)), z(num_cast<T>(q.z)) {}

    friend Quat operator*(const Quat& a, const Quat& b) {
        return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
    }
    friend Quat operator-(const Quat& q) { return {-q.w, -q.x, -q.y, -q.z}; }
    friend bool operator==(const Quat& a, const Quat& b) requires std::is_arithmetic_v<T>
    = default;
};

using Quatd = Quat<double>;

template <class T>
T dot(const Quat<T>& a, const Quat<T>& b) {
    return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Quat<T> conjugate(const Quat<T>& q) {
    return {q.w, -q.x, -q.y, -q.z};
}

template <class T>
Quat<T> normalize(const Quat<T>& q) {
    using std::sqrt;
    const T s = T(1) / sqrt(dot(q, q));
    return {q.w * s, q.x * s, q.y * s, q.z * s};
}

template <class T>
[[gnu::always_inline]] inline Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
    const Vec3<T> u{q.x, q.y, q.z};
    const Vec3<T> t = cross(u, v) * T(2);
    return v + t * q.w + cross(u, t);
}

/// The inverse rotation of `rotate`.
template <class T>
[[gnu::always_inline]] inline Vec3<T> rotate_back(const Quat<T>& q, const Vec3<T>& v) {
    return rotate(conjugate(q), v);
}

/// Turn by `angle` (radians, right-handed, any size) about a unit axis.
inline Quatd quat_from_axis_angle(const Vec3d& unit_axis, double angle) {
    const double s = std::sin(angle / 2);
    return {std::cos(angle / 2), unit_axis.x * s, unit_axis.y * s, unit_axis.z * s};
}

}  // namespace drt
