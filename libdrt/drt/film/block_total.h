#pragma once
// Internal to the film room: walking over blocks and their sums as numbers.

#include "drt/film/film.h"

namespace drt {

/// The sums of one replicate of a block as numbers, and how many samples they are of.
struct BlockTotal {
    std::array<std::array<double, block_pixels>, 4> rgba{};
    double taken = 0;
};

inline BlockTotal total_of(const FilmBlock& block) {
    BlockTotal total;
    total.taken = block.taken;
    for (size_t c = 0; c < 4; ++c)
        for (size_t i = 0; i < block_pixels; ++i)
            total.rgba[c][i] = double(block.rgba[c][i]) / level_scale(ordinary_level);
    for (const FarSum& f : block.far)
        for (size_t i = 0; i < block_pixels; ++i)
            total.rgba[size_t(f.channel)][i] += double(f.sum[i]) / level_scale(f.level);
    return total;
}

/// visit(block number, x, y of its upper left pixel)
template <class Visit>
void for_each_block(const Film& film, Visit visit) {
    size_t number = 0;
    for (int y = 0; y < film.height; y += block_side)
        for (int x = 0; x < film.width; x += block_side) visit(number++, x, y);
}

/// visit(pixel of the block, x, y) for those of the picture.
template <class Visit>
void for_each_pixel(const Film& film, int x0, int y0, Visit visit) {
    for (size_t i = 0; i < block_pixels; ++i) {
        const int x = x0 + block_x[i], y = y0 + block_y[i];
        if (x < film.width && y < film.height) visit(i, x, y);
    }
}

inline BlockTotal operator+(BlockTotal a, const BlockTotal& b) {
    for (size_t c = 0; c < 4; ++c)
        for (size_t i = 0; i < block_pixels; ++i) a.rgba[c][i] += b.rgba[c][i];
    a.taken += b.taken;
    return a;
}

}  // namespace drt
