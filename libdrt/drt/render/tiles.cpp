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
        if (x + even_bits(i) < width && y + even_bits(i >> 1) < height) b.valid |= 1u << i;
    return b;
}

TilePixels make_tile(int x0, int y0, int width, int height, int size) {
    TilePixels t;
    const unsigned blocks = unsigned(size / block_side) * unsigned(size / block_side);
    for (unsigned m = 0; m < blocks; ++m) {
        const int x = x0 + block_side * even_bits(m), y = y0 + block_side * even_bits(m >> 1);
        if (x >= width || y >= height) continue;
        t.blocks.push_back(make_block(x, y, width, height));
        for (unsigned i = 0; i < unsigned(block_pixels); ++i) {
            t.x.push_back(x + even_bits(i));
            t.y.push_back(y + even_bits(i >> 1));
        }
    }
    return t;
}

}  // namespace

std::vector<TilePixels> make_tiles(int width, int height, int size) {
    std::vector<TilePixels> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size) tiles.push_back(make_tile(x, y, width, height, size));
    return tiles;
}

}  // namespace drt
