#include "drt/film/film.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

#include "drt/base/bits.h"

namespace drt {

Film::Film(int w, int h) : width(w), height(h) {
    for (auto& b : blocks) b.resize(size_t(blocks_across()) * size_t(blocks_down()));
}

std::size_t Film::memory() const { return film_memory(width, height); }

std::size_t film_memory(int width, int height) {
    const auto blocks_along = [](int pixels) { return size_t(pixels + block_side - 1) / block_side; };
    return replicate_count * blocks_along(width) * blocks_along(height) * sizeof(FilmBlock);
}

namespace {

// Which block pixel (x, y) is in.
size_t block_index(const Film& film, int x, int y) {
    return size_t(y / block_side) * size_t(film.blocks_across()) + size_t(x / block_side);
}

// Morton number of a pixel within its block.
constexpr int in_block(int x, int y) { return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2; }
constexpr size_t place_in_block(int x, int y) { return size_t(in_block(x & (block_side - 1), y & (block_side - 1))); }
// In fixed point a value is exact above 1 and rounded once below, to the nearest: adding 1.5 * 2^52 to a double leaves
// the integer in its low bits, which needs no conversion to 64-bit integers (AVX2 has none). Here with the bits of the
// 1.5 * 2^52 still on top of it, to be subtracted in unsigned numbers, since several of them wrap around. D is double
// or lanes.
constexpr double magic = 6755399441055744.0;
constexpr auto magic_bits = std::bit_cast<std::uint64_t>(magic);

template <class D>
Rebind<D, std::uint64_t> to_fixed_plus_magic(const D& v) {
    return bits_as<Rebind<D, std::uint64_t>>(D(v * D(fixed_point_scale) + D(magic)));
}

// In lanes by hand: the compiler would go one by one, by its measure of cost here and for fear of overlap below.

// All values are numbers within the limit; a NaN fails the comparison.
bool all_in_range(const BlockSamples& s) {
    using F = Lane<float, std::min(int(stdx::native_simd<float>::size()), block_pixels)>;
    MaskOf<F> good(true);
    for (const float* first : s.rgba)
        for (int k = 0; k < s.count; ++k)
            for (int i = 0; i < block_pixels; i += width_of<F>)
                good = good && abs(load<F>(first + k * s.stride + i)) <= F(sample_limit);
    return all(good);
}

// Every sample is rounded by itself, so that the sum does not depend on how many came at once.
void add_values(std::int64_t* sum, const float* first, std::ptrdiff_t stride, int count) {
    constexpr int width = int(stdx::native_simd<double>::size());
    using D = Lane<double, width>;
    using I = Lane<std::int64_t, width>;
    using U = Lane<std::uint64_t, width>;
    for (int i = 0; i < block_pixels; i += width) {
        U total = bits_as<U>(load<I>(sum + i)) - U(std::uint64_t(count) * magic_bits);
        for (int k = 0; k < count; ++k) total += to_fixed_plus_magic(D(first + k * stride + i, stdx::element_aligned));
        store(bits_as<I>(total), sum + i);
    }
}

}  // namespace

void add_block(Film& film, std::uint32_t first, int x, int y, const BlockSamples& s, FilmCounters& counters) {
    if (s.valid != 0xffff || !all_in_range(s)) {
        for (int k = 0; k < s.count; ++k)
            for (int i = 0; i < block_pixels; ++i) {
                const std::ptrdiff_t at = k * s.stride + i;
                if (s.valid >> i & 1u)
                    add_sample(film, first + std::uint32_t(k * replicate_count), x + block_x[size_t(i)],
                               y + block_y[size_t(i)], {s.rgba[0][at], s.rgba[1][at], s.rgba[2][at], s.rgba[3][at]},
                               counters);
            }
        return;
    }
    FilmBlock& block = film.blocks[size_t(replicate_of(first))][block_index(film, x, y)];
    for (size_t c = 0; c < 4; ++c) add_values(block.rgba[c].data(), s.rgba[c], s.stride, s.count);
    for (std::uint32_t& n : block.samples) n += std::uint32_t(s.count);
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

std::uint32_t samples_at(const Film& film, int replicate, int x, int y) {
    return film.blocks[size_t(replicate)][block_index(film, x, y)].samples[place_in_block(x, y)];
}

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
    FilmBlock& block = film.blocks[size_t(replicate_of(sample))][block_index(film, x, y)];
    const size_t i = place_in_block(x, y);
    for (size_t c = 0; c < 4; ++c) block.rgba[c][i] += std::int64_t(to_fixed_plus_magic(double(value[c])) - magic_bits);
    ++block.samples[i];
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

PixelSum pixel_sum(const Film& film, size_t replicate, int x, int y) {
    const FilmBlock& b = film.blocks[replicate][block_index(film, x, y)];
    const size_t i = place_in_block(x, y);
    return {{b.rgba[0][i], b.rgba[1][i], b.rgba[2][i], b.rgba[3][i]}, b.samples[i]};
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
            const PixelSum s = sum_at(x, y);
            for (size_t c = 0; c < 4; ++c) out.pixel(x, y)[c] = float(mean(s, c));
        }
    return out;
}

}  // namespace

Image resolve(const Film& film) {
    return to_image(film, [&](int x, int y) { return pixel_sum(film, 0, x, y) + pixel_sum(film, 1, x, y); });
}

Image resolve(const Film& film, int replicate) {
    return to_image(film, [&](int x, int y) { return pixel_sum(film, size_t(replicate), x, y); });
}

ErrorEstimate estimate_error(const Film& film) {
    double squared_error = 0, squared_value = 0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const size_t block = block_index(film, x, y), i = place_in_block(x, y);
            const FilmBlock &a = film.blocks[0][block], &b = film.blocks[1][block];
            if (a.samples[i] == 0 || b.samples[i] == 0) return {};
            // Two independent means whose variances go as 1/n: the variance of their weighted mean is
            // (a - b)^2 na nb / (na + nb)^2 in expectation.
            const double na = double(a.samples[i]), nb = double(b.samples[i]), over_n = 1 / (na + nb);
            const double weight = na * nb * over_n * over_n, over_na = 1 / na, over_nb = 1 / nb;
            for (size_t c = 0; c < 3; ++c) {
                const double sum_a = double(a.rgba[c][i]), sum_b = double(b.rgba[c][i]);
                const double difference = sum_a * over_na - sum_b * over_nb, value = (sum_a + sum_b) * over_n;
                squared_error += difference * difference * weight;
                squared_value += value * value;
            }
        }
    squared_error /= fixed_point_scale * fixed_point_scale;
    squared_value /= fixed_point_scale * fixed_point_scale;
    ErrorEstimate e;
    e.rmse = std::sqrt(squared_error / (3.0 * film.width * film.height));
    e.relative = squared_value > 0 ? std::sqrt(squared_error / squared_value) : 0;
    e.valid = film.width > 0 && film.height > 0;
    return e;
}

}  // namespace drt
