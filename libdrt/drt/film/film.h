#pragma once
// The film: per-pixel sums that are the same bits whatever the order of threads, tiles, passes and machines.
//
// Every sample lands in exactly one pixel (filter importance sampling), is rounded once to 64-bit fixed point
// (value * 2^24) and added: integer addition commutes. Samples alternate between two replicates A and B with
// independent scrambles; over a picture's many pixels, RMS(A - B) / 2 is a sharp estimate of the picture's error
// (the variance of samples inside one low-discrepancy set is not).

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drt/image/image.h"

namespace drt {

inline constexpr int replicate_count = 2;
inline constexpr double fixed_point_scale = 16777216.0;  ///< 2^24
inline constexpr float sample_limit = 65536.0f;          ///< 2^16: larger samples are clamped and counted

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

/// Sums of one replicate over the pixels of a block, next to each other in memory: a block is all that a packet
/// touches.
struct FilmBlock {
    std::array<std::array<std::int64_t, block_pixels>, 4> rgba{};
    std::array<std::uint32_t, block_pixels> samples{};
    friend bool operator==(const FilmBlock&, const FilmBlock&) = default;
};

struct FilmCounters {
    std::uint64_t nonfinite = 0;  ///< samples dropped
    std::uint64_t clamped = 0;    ///< samples cut at sample_limit
    /// Of the lowest sample, row, column.
    int first_nonfinite_x = -1, first_nonfinite_y = -1;
    std::uint32_t first_nonfinite_sample = 0;
};

struct Film {
    int width = 0, height = 0;
    std::array<std::vector<FilmBlock>, replicate_count> blocks;  ///< row by row

    Film() = default;
    Film(int w, int h);
    int blocks_across() const { return (width + block_side - 1) / block_side; }
    int blocks_down() const { return (height + block_side - 1) / block_side; }
    std::size_t memory() const;
};

/// Bytes of a film of this size.
std::size_t film_memory(int width, int height);

/// How many samples pixel (x, y) has in a replicate.
std::uint32_t samples_at(const Film&, int replicate, int x, int y);

/// Samples of all pixels of a block, in the block's order: each of one replicate, one after the other.
struct BlockSamples {
    std::array<const float*, 4> rgba;  ///< 16 values each, of the first sample
    std::ptrdiff_t stride = 0;         ///< to the values of the next sample
    int count = 1;                     ///< samples of each pixel
    unsigned valid = 0xffff;           ///< bit i: pixel i is part of the picture
};

/// Adds samples `first`, first + replicate_count, first + 2 replicate_count, ... of all pixels of the block whose upper
/// left pixel is (x, y), multiples of 4. Different threads may add to different blocks.
void add_block(Film&, std::uint32_t first, int x, int y, const BlockSamples&, FilmCounters&);

/// Adds one sample of one pixel.
void add_sample(Film&, std::uint32_t sample, int x, int y, const std::array<float, 4>& rgba, FilmCounters&);

void merge(FilmCounters& into, const FilmCounters& from);

/// The picture so far: RGBA means over all samples; pixels without samples are 0.
Image resolve(const Film&);
/// The picture of one replicate.
Image resolve(const Film&, int replicate);

struct ErrorEstimate {
    double rmse = 0;      ///< root mean square error of the picture's RGB values
    double relative = 0;  ///< rmse / root mean square of the picture's RGB values
    bool valid = false;   ///< false until every pixel has a sample in both replicates
};

/// The picture's error from the two replicates. Sharp (a few percent) over 1e4 and more pixels; it knows nothing of
/// rare light that no sample has met.
ErrorEstimate estimate_error(const Film&);

}  // namespace drt
