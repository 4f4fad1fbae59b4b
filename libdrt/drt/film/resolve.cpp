#include "drt/film/block_total.h"

namespace drt {

namespace {

template <class TotalOf>
Image to_image(const Film& film, TotalOf total_at) {
    Image out(film.width, film.height, 4);
    for_each_block(film, [&](size_t block, int x0, int y0) {
        const BlockTotal total = total_at(block);
        if (total.taken == 0) return;
        for_each_pixel(film, x0, y0, [&](size_t i, int x, int y) {
            for (size_t c = 0; c < 4; ++c) out.pixel(x, y)[c] = float(total.rgba[c][i] / total.taken);
        });
    });
    return out;
}

}  // namespace

Image resolve(const Film& film) {
    return to_image(film,
                    [&](size_t block) { return total_of(film.blocks[0][block]) + total_of(film.blocks[1][block]); });
}

Image resolve(const Film& film, int replicate) {
    return to_image(film, [&](size_t block) { return total_of(film.blocks[size_t(replicate)][block]); });
}

}  // namespace drt
