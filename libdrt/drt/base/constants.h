#pragma once

#include <numbers>

namespace drt {

template <class T>
inline constexpr T pi = std::numbers::pi_v<T>;

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

}  // namespace drt
