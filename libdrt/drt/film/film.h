#pragma once
// The film: per-pixel sums that are the same bits whatever the order of threads, tiles, passes and machines.
//
// Every sample lands in exactly one pixel (filter importance sampling) and is added without rounding, whatever its
// magnitude, to integers (levels.h): integer addition commutes, so any parts of a picture merge, and a picture scales
// with its lights. Samples alternate between two replicates A and B with independent scrambles; over a picture's many
// pixels, RMS(A - B) / 2 is a sharp estimate of the picture's error (the variance of samples inside one low-discrepancy
// set is not).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drt/film/levels.h"
#include "drt/image/image.h"

namespace drt {

inline constexpr int replicate_count = 2;

constexpr int replicate_of(std::uint32_t sample) { return int(sample % replicate_count); }
constexpr std::uint32_t index_in_replicate(std::uint32_t sample) { return sample / replicate_count; }

/// Pixels are stored in blocks of 4 x 4, in Morton order within a block, so that a packet of neighbouring pixels is
/// contiguous whatever its width, and adding it is a few vector instructions.
inline constexpr int block_side = 4;
inline constexpr int block_pixels = block_side * block_side;
/// Where pixel i of a block lies within it.
alignas(64) inline constexpr std::array<std::int32_t, block_pixels> block_x{0, 1, 0, 1, 2, 3, 2, 3,
                                                                            0, 1, 0, 1, 2, 3, 2, 3};
alignas(64) inline constexpr std::array<std::int32_t, block_pixels> block_y{0, 0, 1, 1, 0, 0, 1, 1,
                                                                            2, 2, 3, 3, 2, 2, 3, 3};

using BlockSum = std::array<std::int64_t, block_pixels>;

/// The sum of one channel over another level than the ordinary one.
struct FarSum {
    std::int32_t channel = 0, level = 0;
    BlockSum sum{};
    friend bool operator==(const FarSum&, const FarSum&) = default;
};

/// Sums of one replicate over the pixels of a block, next to each other in memory: a block is all that a packet
/// touches. It starts on a cache line.
struct alignas(64) FilmBlock {
    std::array<BlockSum, 4> rgba{};  ///< the ordinary level
    std::vector<FarSum> far;         ///< made when first touched; ordered by channel and level
    std::uint32_t taken = 0;         ///< samples of each pixel, dropped ones among them
    friend bool operator==(const FilmBlock&, const FilmBlock&) = default;
};

/// Samples of which something is lost.
struct LostSamples {
    std::uint64_t count = 0;
    /// Of the lowest sample, row, column.
    int first_x = -1, first_y = -1;
    std::uint32_t first_sample = 0;
};

struct FilmCounters {
    LostSamples nonfinite;   ///< not a number in some channel: counted as taken, with value 0
    LostSamples overflowed;  ///< too bright for a float: counted as the largest one
};

struct Film {
    int width = 0, height = 0;
    std::array<std::vector<FilmBlock>, replicate_count> blocks;  ///< row by row

    Film() = default;
    Film(int w, int h);
    int blocks_across() const { return (width + block_side - 1) / block_side; }
    int blocks_down() const { return (height + block_side - 1) / block_side; }
    std::size_t memory() const;  ///< as it is, levels that were touched included
};

/// Bytes of a film of this size whose light is ordinary. Each channel and level of a block (of one replicate) that
/// turns out to have other light takes sizeof(FarSum) more.
std::size_t film_memory(int width, int height);

/// How many samples pixel (x, y) has in a replicate.
std::uint32_t samples_at(const Film&, int replicate, int x, int y);

/// Samples of all pixels of a block, in the block's order: each of one replicate, one after the other. Pixels beyond
/// the picture's edge are 0.
struct BlockSamples {
    std::array<const float*, 4> rgba;  ///< 16 values each, of the first sample
    std::ptrdiff_t stride = 0;         ///< to the values of the next sample
    int count = 1;                     ///< samples of each pixel
};

/// Adds samples `first`, first + replicate_count, first + 2 replicate_count, ... of all pixels of the block whose upper
/// left pixel is (x, y), multiples of 4. Different threads may add to different blocks. No more than most_summands of a
/// replicate.
void add_block(Film&, std::uint32_t first, int x, int y, const BlockSamples&, FilmCounters&);

/// Adds the samples of another part of the same picture.
void merge(Film& into, const Film& from);

void merge(FilmCounters& into, const FilmCounters& from);

/// The picture so far: RGBA means over all samples; pixels without samples are 0.
Image resolve(const Film&);
/// The picture of one replicate.
Image resolve(const Film&, int replicate);

}  // namespace drt
