#pragma once
// Films made sample by sample.

#include <array>

#include "drt/film/film.h"

namespace drt {

/// One sample of each pixel of a block: [channel][pixel of the block].
using BlockValues = std::array<std::array<float, block_pixels>, 4>;

inline BlockSamples one_sample(const BlockValues& v) {
    return {{v[0].data(), v[1].data(), v[2].data(), v[3].data()}, 0, 1};
}

/// A film of one pixel, to which samples are added one by one.
struct PixelFilm {
    Film film{1, 1};
    FilmCounters counters;
    void add(std::uint32_t sample, const std::array<float, 4>& rgba) {
        BlockValues v{};
        for (size_t c = 0; c < 4; ++c) v[c][0] = rgba[c];
        add_block(film, sample, 0, 0, one_sample(v), counters);
    }
    std::vector<float> mean() const { return resolve(film).data; }
};

}  // namespace drt
