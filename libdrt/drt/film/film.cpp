#include "drt/film/film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace drt {

Film::Film(int w, int h) : width(w), height(h) {
    const size_t size = size_t(blocks_across()) * size_t(blocks_down()) * block_pixels;
    for (FilmPlanes& p : planes) {
        for (auto& plane : p.rgba) plane.resize(size);
        p.samples.resize(size);
    }
}

std::size_t Film::memory() const {
    return planes.size() * planes[0].samples.size() * (4 * sizeof(std::int64_t) + sizeof(std::uint32_t));
}

namespace {

size_t block_start(const Film& film, int x, int y) {
    return (size_t(y / block_side) * size_t(film.blocks_across()) + size_t(x / block_side)) * block_pixels;
}

// Morton number of a pixel within its block, and back.
constexpr int in_block(int x, int y) { return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2; }
constexpr int x_in_block(int i) { return (i & 1) | (i >> 1 & 2); }
constexpr int y_in_block(int i) { return (i >> 1 & 1) | (i >> 2 & 2); }
static_assert(x_in_block(in_block(3, 1)) == 3 && y_in_block(in_block(3, 1)) == 1);

// The value is exact in fixed point above 1 and rounded once below; scaling by a power of two loses nothing.
std::int64_t to_fixed(float v) { return std::int64_t(std::nearbyint(v * float(fixed_point_scale))); }

// All 16 values are numbers within the limit: NaN and infinity compare above it as bit patterns.
bool all_in_range(const float* v) {
    unsigned bad = 0;
    for (int i = 0; i < block_pixels; ++i)
        bad |=
            unsigned((std::bit_cast<std::uint32_t>(v[i]) & 0x7fffffffu) > std::bit_cast<std::uint32_t>(sample_limit));
    return bad == 0;
}

}  // namespace

std::size_t film_index(const Film& film, int x, int y) {
    return block_start(film, x, y) + size_t(in_block(x & (block_side - 1), y & (block_side - 1)));
}

void add_block(Film& film, std::uint32_t sample, int x, int y, const BlockSamples& s, FilmCounters& counters) {
    const bool plain = s.valid == 0xffff && all_in_range(s.rgba[0]) && all_in_range(s.rgba[1]) &&
                       all_in_range(s.rgba[2]) && all_in_range(s.rgba[3]);
    if (!plain) {
        for (int i = 0; i < block_pixels; ++i)
            if (s.valid >> i & 1u)
                add_sample(film, sample, x + x_in_block(i), y + y_in_block(i),
                           {s.rgba[0][i], s.rgba[1][i], s.rgba[2][i], s.rgba[3][i]}, counters);
        return;
    }
    FilmPlanes& planes = film.planes[size_t(replicate_of(sample))];
    const size_t start = block_start(film, x, y);
    for (size_t c = 0; c < 4; ++c) {  // plain loops: the compiler turns them into vector conversions and adds
        std::int64_t* sum = &planes.rgba[c][start];
        const float* v = s.rgba[c];
        for (int i = 0; i < block_pixels; ++i) sum[i] += to_fixed(v[i]);
    }
    std::uint32_t* n = &planes.samples[start];
    for (int i = 0; i < block_pixels; ++i) ++n[i];
}

namespace {

// The first of all, whatever the order in which threads meet them.
void note_nonfinite(FilmCounters& counters, std::uint32_t sample, int x, int y) {
    const auto place = std::tuple(sample, y, x);
    const auto first =
        std::tuple(counters.first_nonfinite_sample, counters.first_nonfinite_y, counters.first_nonfinite_x);
    if (counters.nonfinite > 0 && first <= place) return;
    counters.first_nonfinite_x = x;
    counters.first_nonfinite_y = y;
    counters.first_nonfinite_sample = sample;
}

}  // namespace

void add_sample(Film& film, std::uint32_t sample, int x, int y, const std::array<float, 4>& rgba,
                FilmCounters& counters) {
    std::array<float, 4> value = rgba;
    if (!std::all_of(rgba.begin(), rgba.end(), [](float v) { return std::isfinite(v); })) {
        note_nonfinite(counters, sample, x, y);
        ++counters.nonfinite;
        return;
    }
    for (float& v : value) v = std::clamp(v, -sample_limit, sample_limit);
    if (value != rgba) ++counters.clamped;
    FilmPlanes& planes = film.planes[size_t(replicate_of(sample))];
    const size_t i = film_index(film, x, y);
    for (size_t c = 0; c < 4; ++c) planes.rgba[c][i] += to_fixed(value[c]);
    ++planes.samples[i];
}

void merge(FilmCounters& into, const FilmCounters& from) {
    if (from.nonfinite > 0)
        note_nonfinite(into, from.first_nonfinite_sample, from.first_nonfinite_x, from.first_nonfinite_y);
    into.nonfinite += from.nonfinite;
    into.clamped += from.clamped;
}

namespace {

// One pixel of one replicate.
struct PixelSum {
    std::array<std::int64_t, 4> rgba{};
    std::uint64_t samples = 0;
};

PixelSum pixel_sum(const FilmPlanes& planes, size_t i) {
    return {{planes.rgba[0][i], planes.rgba[1][i], planes.rgba[2][i], planes.rgba[3][i]}, planes.samples[i]};
}

PixelSum operator+(const PixelSum& a, const PixelSum& b) {
    PixelSum s{{}, a.samples + b.samples};
    for (size_t c = 0; c < 4; ++c) s.rgba[c] = a.rgba[c] + b.rgba[c];
    return s;
}

double mean(const PixelSum& s, size_t c) {
    return s.samples == 0 ? 0.0 : double(s.rgba[c]) / (fixed_point_scale * double(s.samples));
}

template <class SumAt>
Image to_image(const Film& film, SumAt sum_at) {
    Image out(film.width, film.height, 4);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const PixelSum s = sum_at(film_index(film, x, y));
            for (size_t c = 0; c < 4; ++c) out.pixel(x, y)[c] = float(mean(s, c));
        }
    return out;
}

}  // namespace

Image resolve(const Film& film) {
    return to_image(film, [&](size_t i) { return pixel_sum(film.planes[0], i) + pixel_sum(film.planes[1], i); });
}

Image resolve(const Film& film, int replicate) {
    return to_image(film, [&](size_t i) { return pixel_sum(film.planes[size_t(replicate)], i); });
}

ErrorEstimate estimate_error(const Film& film) {
    double squared_error = 0, squared_value = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const size_t i = film_index(film, x, y);
            const PixelSum a = pixel_sum(film.planes[0], i), b = pixel_sum(film.planes[1], i), both = a + b;
            if (a.samples == 0 || b.samples == 0) return {};
            // Two independent means whose variances go as 1/n: the variance of their weighted mean is
            // (a - b)^2 na nb / (na + nb)^2 in expectation.
            const double na = double(a.samples), nb = double(b.samples);
            const double weight = na * nb / ((na + nb) * (na + nb));
            for (size_t c = 0; c < 3; ++c) {
                const double difference = mean(a, c) - mean(b, c), value = mean(both, c);
                squared_error += difference * difference * weight;
                squared_value += value * value;
            }
        }
    ErrorEstimate e;
    e.rmse = std::sqrt(squared_error / (3.0 * film.width * film.height));
    e.relative = squared_value > 0 ? std::sqrt(squared_error / squared_value) : 0;
    e.valid = film.width > 0 && film.height > 0;
    return e;
}

}  // namespace drt
