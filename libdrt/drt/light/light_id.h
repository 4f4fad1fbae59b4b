#pragma once
// The name of a light: its kind and its place in the array of its kind.

#include <cstdint>

namespace drt {

enum class LightKind : std::int32_t { point, rect, sphere };
inline constexpr int light_kinds = 3;

using LightId = std::int32_t;  ///< an int, so that lanes carry it
inline constexpr LightId no_light = -1;

namespace light_id {
[[gnu::always_inline]] constexpr LightId pack(LightKind kind, std::size_t index) {
    return LightId(index << 2 | std::size_t(kind));
}
[[gnu::always_inline]] constexpr LightKind kind(LightId id) { return LightKind(id & 3); }
/// Of one id, or of lanes of ids.
template <class I>
[[gnu::always_inline]] constexpr I index(const I& id) {
    return id >> 2;
}
}  // namespace light_id

}  // namespace drt
