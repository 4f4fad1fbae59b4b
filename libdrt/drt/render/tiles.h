#pragma once

#include <vector>

#include "drt/stages/stage.h"

namespace drt {

using Tile = std::vector<TileBlock>;  ///< in Morton order

/// The picture cut into square tiles, row by row, of whole film blocks; those at the right and lower edge may be
/// smaller. `size` is a power of two, 4 to 32 (a batch holds at least one sample of a tile).
std::vector<Tile> make_tiles(int width, int height, int size);

}  // namespace drt
