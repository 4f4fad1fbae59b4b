#include "drt/render/tiles.h"

#include <algorithm>

namespace drt {

namespace {

// Every second bit of v, packed: x from the even bits of a Morton number, y from the odd ones.
int even_bits(unsigned v) {
    int out = 0;
    for (int i = 0; i < 16; ++i) out |= int((v >> (2 * i)) & 1u) << i;
    return out;
}

TilePixels make_tile(int x0, int y0, int width, int height, int size) {
    constexpr size_t widest_packet = 16;
    TilePixels t;
    for (unsigned m = 0; m < unsigned(size) * unsigned(size); ++m) {
        const int x = x0 + even_bits(m), y = y0 + even_bits(m >> 1);
        if (x >= width || y >= height) continue;
        t.x.push_back(x);
        t.y.push_back(y);
    }
    t.count = int(t.x.size());
    const size_t padded = (t.x.size() + widest_packet - 1) / widest_packet * widest_packet;
    t.x.resize(padded, t.x.back());
    t.y.resize(padded, t.y.back());
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
