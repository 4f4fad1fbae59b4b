#pragma once
// Small fixed-size vectors, templated over the number type: float, double or a SIMD lane type.
// Points, directions and normals are Vec3; colours are Color3 (color.h), on purpose another type.

#include "drt/base/simd.h"

namespace drt {

template <class T>
struct Vec2 {
    T x{}, y{};
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

template <class T>
struct Vec3 {
    T x{}, y{}, z{};

    Vec3() = default;
    constexpr Vec3(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
    /// Converts between number types: scalar precision, scalar broadcast to lanes, lanes to lanes.
    template <class U>
    explicit constexpr Vec3(const Vec3<U>& v) : x(num_cast<T>(v.x)), y(num_cast<T>(v.y)), z(num_cast<T>(v.z)) {}

    Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
    Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
    Vec3& operator*=(const T& s) { return *this = *this * s; }

    [[gnu::always_inline]] friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
    [[gnu::always_inline]] friend constexpr Vec3 operator*(const Vec3& a, const T& s) {
        return {a.x * s, a.y * s, a.z * s};
    }
    [[gnu::always_inline]] friend constexpr Vec3 operator*(const T& s, const Vec3& a) { return a * s; }
    [[gnu::always_inline]] friend constexpr Vec3 operator/(const Vec3& a, const T& s) { return a * (T(1) / s); }
    friend bool operator==(const Vec3& a, const Vec3& b) requires std::is_arithmetic_v<T>
    = default;
};

template <class T>
[[gnu::always_inline]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
[[gnu::always_inline]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
[[gnu::always_inline]] inline T length_squared(const Vec3<T>& a) {
    return dot(a, a);
}

template <class T>
[[gnu::always_inline]] inline T length(const Vec3<T>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// Undefined (NaN) for the zero vector: callers check where zero can occur.
template <class T>
[[gnu::always_inline]] inline Vec3<T> normalize(const Vec3<T>& a) {
    return a * inverse_sqrt(dot(a, a));
}

template <class T>
[[gnu::always_inline]] inline Vec3<T> select(const MaskOf<T>& m, const Vec3<T>& a, const Vec3<T>& b) {
    return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}

template <class T>
bool is_finite(const Vec3<T>& v) requires std::is_arithmetic_v<T> {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Component `axis` in 0..2.
template <class T>
T component(const Vec3<T>& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

using Vec2d = Vec2<double>;
using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;

}  // namespace drt
