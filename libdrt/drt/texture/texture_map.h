#pragma once
// A picture prepared for filtered lookups: all its levels of detail in one array.

#include <cstdint>
#include <vector>

#include "drt/base/color.h"
#include "drt/image/image.h"

namespace drt {

/// A mip pyramid (Williams, "Pyramidal parametrics", 1983) of linear RGB texels. Level 0 is the picture; each further
/// level halves both sides (rounded down, at least 1) and the last one is the single mean texel. Every level has the
/// mean of the picture, whatever its size: texels are averaged by the area they share, in double precision.
///
/// (u, v) = (0, 0) is the upper left corner of the picture, u runs right and v down, (1, 1) is the lower right corner;
/// texel centres lie at (i + 1/2) / side and the picture repeats in both directions.
struct TextureMap {
    struct Level {
        std::int32_t width = 0, height = 0;  ///< texels
        std::int32_t offset = 0;             ///< of the first texel in `texels`, in floats
    };
    std::vector<Level> levels;
    std::vector<float> texels;  ///< 4 floats a texel (R, G, B, unused), so that no texel straddles a cache line
};

inline constexpr int floats_per_texel = 4;

/// From a picture with at least 3 channels (the first three are used) and finite values. Takes 16 bytes a texel, and a
/// third more for the smaller levels. Throws Error (asset) when that is more than 2^31 floats (about 20000 x 20000).
TextureMap make_texture_map(const Image&);

/// A board of squares x squares fields (an even number tiles seamlessly), `a` in the upper left one.
TextureMap make_checker(const Color& a, const Color& b, int squares, int texels_per_square);

/// What is shown instead of a texture that could not be read: magenta and grey, which nobody paints on purpose.
TextureMap make_missing_texture();

}  // namespace drt
