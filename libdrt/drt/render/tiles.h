#pragma once

#include <vector>

#include "drt/stages/stage.h"

namespace drt {

/// The picture cut into square tiles, row by row; the tiles at the right and lower edge may be smaller.
/// Pixels within a tile are in Morton order and padded to whole packets. `size` is a power of two.
std::vector<TilePixels> make_tiles(int width, int height, int size);

}  // namespace drt
