#include "drt/render/tiles.h"

namespace drt {

namespace {

// Every second bit of v, packed: x from the even bits of a Morton number, y from the odd ones.
int even_bits(unsigned v) {
    int out = 0;
    for (int i = 0; i < 16; ++i) out |= int((v >> (2 * i)) & 1u) << i;
    return out;
}

TileBlock make_block(int x, int y, int width, int height) {
    TileBlock b{x, y, 0};
    for (unsigned i = 0; i < unsigned(block_pixels); ++i)
        if (x + block_x[i] < width && y + block_y[i] < height) b.valid |= 1u << i;
    return b;
}

Tile make_tile(int x0, int y0, int width, int height, int size) {
    Tile tile;
    const unsigned blocks = unsigned(size / block_side) * unsigned(size / block_side);
    for (unsigned m = 0; m < blocks; ++m) {
        const int x = x0 + block_side * even_bits(m), y = y0 + block_side * even_bits(m >> 1);
        if (x < width && y < height) tile.push_back(make_block(x, y, width, height));
    }
    return tile;
}

}  // namespace

std::vector<Tile> make_tiles(int width, int height, int size) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size) tiles.push_back(make_tile(x, y, width, height, size));
    return tiles;
}

}  // namespace drt
