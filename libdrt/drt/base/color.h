#pragma once
// Linear RGB with Rec. 709 primaries, unbounded. A type of its own: a colour is not a vector, and
// `Vec3 * Color3` does not compile.

#include <algorithm>

#include "drt/base/simd.h"

namespace drt {

template <class T>
struct Color3 {
    T r{}, g{}, b{};

    Color3() = default;
    constexpr Color3(T r_, T g_, T b_) : r(r_), g(g_), b(b_) {}
    explicit constexpr Color3(T grey) : r(grey), g(grey), b(grey) {}
    template <class U>
    explicit constexpr Color3(const Color3<U>& c) : r(num_cast<T>(c.r)), g(num_cast<T>(c.g)), b(num_cast<T>(c.b)) {}

    Color3& operator+=(const Color3& o) { return *this = *this + o; }
    Color3& operator*=(const Color3& o) { return *this = *this * o; }
    Color3& operator*=(const T& s) { return *this = *this * s; }

    [[gnu::always_inline]] friend constexpr Color3 operator+(const Color3& a, const Color3& c) {
        return {a.r + c.r, a.g + c.g, a.b + c.b};
    }
    [[gnu::always_inline]] friend constexpr Color3 operator-(const Color3& a, const Color3& c) {
        return {a.r - c.r, a.g - c.g, a.b - c.b};
    }
    [[gnu::always_inline]] friend constexpr Color3 operator*(const Color3& a, const Color3& c) {
        return {a.r * c.r, a.g * c.g, a.b * c.b};
    }
    [[gnu::always_inline]] friend constexpr Color3 operator*(const Color3& a, const T& s) {
        return {a.r * s, a.g * s, a.b * s};
    }
    [[gnu::always_inline]] friend constexpr Color3 operator*(const T& s, const Color3& a) { return a * s; }
    friend bool operator==(const Color3& a, const Color3& c) requires std::is_arithmetic_v<T>
    = default;
};

template <class T>
[[gnu::always_inline]] inline Color3<T> select(const MaskOf<T>& m, const Color3<T>& a, const Color3<T>& c) {
    return {select(m, a.r, c.r), select(m, a.g, c.g), select(m, a.b, c.b)};
}

template <class T>
[[gnu::always_inline]] inline T max_component(const Color3<T>& c) {
    return max(c.r, max(c.g, c.b));
}

/// Rec. 709 luminance.
template <class T>
[[gnu::always_inline]] inline T luminance(const Color3<T>& c) {
    return T(0.2126f) * c.r + T(0.7152f) * c.g + T(0.0722f) * c.b;
}

inline bool is_black(const Color3<float>& c) { return c.r == 0 && c.g == 0 && c.b == 0; }

/// The sRGB transfer curve (IEC 61966-2-1), scalar: for 8-bit files and '#rrggbb', not for the hot path.
inline float srgb_to_linear(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
inline float linear_to_srgb(float v) {
    return v <= 0.0031308f ? v * 12.92f : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

using Color = Color3<float>;

}  // namespace drt
