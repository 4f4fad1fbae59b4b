#include "drt/film/film.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <tuple>

#include "drt/base/bits.h"

namespace drt {

Film::Film(int w, int h) : width(w), height(h) {
    for (auto& b : blocks) b.resize(size_t(blocks_across()) * size_t(blocks_down()));
}

std::size_t Film::memory() const {
    std::size_t bytes = film_memory(width, height);
    for (const auto& replicate : blocks)
        for (const FilmBlock& b : replicate) bytes += b.far.capacity() * sizeof(FarSum);
    return bytes;
}

std::size_t film_memory(int width, int height) {
    const auto blocks_along = [](int pixels) { return size_t(pixels + block_side - 1) / block_side; };
    return replicate_count * blocks_along(width) * blocks_along(height) * sizeof(FilmBlock);
}

namespace {

// Which block pixel (x, y) is in.
size_t block_index(const Film& film, int x, int y) {
    return size_t(y / block_side) * size_t(film.blocks_across()) + size_t(x / block_side);
}

// Adding 1.5 * 2^52 to a double leaves the integer in its low bits, which needs no conversion to 64-bit integers (AVX2
// has none). Here with the bits of the 1.5 * 2^52 still on top of it, to be subtracted in unsigned numbers, since
// several of them wrap around. D is double or lanes.
constexpr double magic = 6755399441055744.0;
constexpr auto magic_bits = std::bit_cast<std::uint64_t>(magic);

template <class D>
[[gnu::always_inline]] inline Rebind<D, std::uint64_t> to_fixed_plus_magic(const D& v, const D& scale) {
    return bits_as<Rebind<D, std::uint64_t>>(D(v * scale + D(magic)));
}

// In lanes by hand: the compiler would go one by one, by its measure of cost here and for fear of overlap below.
using F = Lane<float, std::min(int(stdx::native_simd<float>::size()), block_pixels)>;
using FI = Rebind<F, std::int32_t>;
using D = Lane<double, int(stdx::native_simd<double>::size())>;
using DF = Rebind<D, float>;
using DI = Rebind<D, std::int32_t>;

constexpr std::int32_t infinity_bits = 0x7f800000;

// Ordered as the magnitudes are; beyond infinity if v is not a number.
template <class V>
[[gnu::always_inline]] inline Rebind<V, std::int32_t> magnitude_bits(const V& v) {
    return bits_as<Rebind<V, std::int32_t>>(v) & Rebind<V, std::int32_t>(0x7fffffff);
}

// fold(packet) over all values of a channel.
template <class Fold>
[[gnu::always_inline]] inline void for_each_packet(const float* first, std::ptrdiff_t stride, int count, Fold fold) {
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < block_pixels; i += width_of<F>) fold(load<F>(first + k * stride + i));
}

// Everything is 0 or of the ordinary level. In one comparison for each end: without its 1, zero is the largest of
// unsigned numbers.
bool all_ordinary(const BlockSamples& s) {
    using U = Rebind<F, std::uint32_t>;
    FI largest(0);
    U least_less_1(~0u);
    for (const float* first : s.rgba)
        for_each_packet(first, s.stride, s.count, [&](const F& v) {
            const FI bits = magnitude_bits(v);
            largest = max(largest, bits);
            least_less_1 = min(least_less_1, bits_as<U>(bits) - U(1));
        });
    return all(largest < FI(first_bits(ordinary_level + 1))) &&
           all(least_less_1 >= U(std::uint32_t(first_bits(ordinary_level) - 1)));
}

template <class Value>
[[gnu::always_inline]] inline void add_values(BlockSum& sum, int level, int count, Value value) {
    using I = Lane<std::int64_t, width_of<D>>;
    using U = Lane<std::uint64_t, width_of<D>>;
    const D scale(level_scale(level));
    for (int i = 0; i < block_pixels; i += width_of<D>) {
        std::int64_t* at = sum.data() + i;
        U total = bits_as<U>(load<I>(at)) - U(std::uint64_t(count) * magic_bits);
        for (int k = 0; k < count; ++k) total += to_fixed_plus_magic(D(num_cast<D>(value(k, i))), scale);
        store(bits_as<I>(total), at);
    }
}

// All values of a channel, which are of one level.
void add_channel(BlockSum& sum, int level, const float* first, std::ptrdiff_t stride, int count) {
    add_values(sum, level, count, [&](int k, int i) { return load<DF>(first + k * stride + i); });
}

// Those values of a channel that are of this level.
void add_level_of_channel(BlockSum& sum, int level, const float* first, std::ptrdiff_t stride, int count) {
    const DI least(first_bits(level)), next(first_bits(level + 1));
    add_values(sum, level, count, [&](int k, int i) {
        const DF v = load<DF>(first + k * stride + i);
        const DI bits = magnitude_bits(v);
        return select(mask_cast<DF>(bits >= least && bits < next), v, DF(0));
    });
}

// Bit l: some value of the channel is of level l.
unsigned levels_of(const float* first, std::ptrdiff_t stride, int count) {
    FI found(0);
    for_each_packet(first, stride, count, [&](const F& v) {
        const FI bits = magnitude_bits(v);
        found |= select(bits > FI(0), FI(FI(1) << level_of(bits)), FI(0));
    });
    unsigned levels = 0;
    for (int i = 0; i < width_of<F>; ++i) levels |= unsigned(found[i]);
    return levels;
}

BlockSum& sum_at(FilmBlock& block, int channel, int level) {
    if (level == ordinary_level) return block.rgba[size_t(channel)];
    const auto at = std::find_if(block.far.begin(), block.far.end(), [&](const FarSum& s) {
        return std::tuple(s.channel, s.level) >= std::tuple(channel, level);
    });
    if (at != block.far.end() && at->channel == channel && at->level == level) return at->sum;
    return block.far.insert(at, {channel, level, {}})->sum;
}

void add_finite(FilmBlock& block, const BlockSamples& s) {
    for (int c = 0; c < 4; ++c) {
        const float* first = s.rgba[size_t(c)];
        const unsigned levels = levels_of(first, s.stride, s.count);
        if (std::has_single_bit(levels)) {
            const int level = std::countr_zero(levels);
            add_channel(sum_at(block, c, level), level, first, s.stride, s.count);
            continue;
        }
        for (unsigned rest = levels; rest != 0; rest &= rest - 1) {
            const int level = std::countr_zero(rest);
            add_level_of_channel(sum_at(block, c, level), level, first, s.stride, s.count);
        }
    }
}

bool all_finite(const BlockSamples& s) {
    FI largest(0);
    for (const float* first : s.rgba)
        for_each_packet(first, s.stride, s.count, [&](const F& v) { largest = max(largest, magnitude_bits(v)); });
    return all(largest < FI(infinity_bits));
}

// The first of all, whatever the order in which threads meet them.
void note(LostSamples& lost, const LostSamples& other) {
    if (other.count == 0) return;
    const auto place = [](const LostSamples& l) { return std::tuple(l.first_sample, l.first_y, l.first_x); };
    const std::uint64_t sum = lost.count + other.count;
    if (lost.count == 0 || place(other) < place(lost)) lost = other;
    lost.count = sum;
}

// One sample of each pixel, with the number that stands for what is not finite.
void add_mended(FilmBlock& block, std::uint32_t sample, int x, int y, const std::array<const float*, 4>& rgba,
                FilmCounters& counters) {
    constexpr float largest = std::numeric_limits<float>::max();
    std::array<std::array<float, block_pixels>, 4> mended;
    for (size_t i = 0; i < block_pixels; ++i) {
        const LostSamples here{1, x + block_x[i], y + block_y[i], sample};
        std::array<float, 4> v{rgba[0][i], rgba[1][i], rgba[2][i], rgba[3][i]};
        if (std::any_of(v.begin(), v.end(), [](float f) { return magnitude_bits(f) > infinity_bits; })) {
            note(counters.nonfinite, here);
            v = {};
        } else if (std::any_of(v.begin(), v.end(), [](float f) { return magnitude_bits(f) == infinity_bits; })) {
            note(counters.overflowed, here);
            for (float& f : v) f = std::clamp(f, -largest, largest);
        }
        for (size_t c = 0; c < 4; ++c) mended[c][i] = v[c];
    }
    add_finite(block, {{mended[0].data(), mended[1].data(), mended[2].data(), mended[3].data()}, 0, 1});
}

}  // namespace

std::uint32_t samples_at(const Film& film, int replicate, int x, int y) {
    return film.blocks[size_t(replicate)][block_index(film, x, y)].taken;
}

void add_block(Film& film, std::uint32_t first, int x, int y, const BlockSamples& s, FilmCounters& counters) {
    FilmBlock& block = film.blocks[size_t(replicate_of(first))][block_index(film, x, y)];
    block.taken += std::uint32_t(s.count);
    if (all_ordinary(s)) {
        for (size_t c = 0; c < 4; ++c) add_channel(block.rgba[c], ordinary_level, s.rgba[c], s.stride, s.count);
        return;
    }
    if (all_finite(s)) return add_finite(block, s);
    for (int k = 0; k < s.count; ++k) {
        std::array<const float*, 4> rgba = s.rgba;
        for (const float*& channel : rgba) channel += k * s.stride;
        add_mended(block, first + std::uint32_t(k * replicate_count), x, y, rgba, counters);
    }
}

void merge(Film& into, const Film& from) {
    if (into.width != from.width || into.height != from.height)
        throw std::invalid_argument("parts of pictures of different sizes");
    const auto add = [](BlockSum& sum, const BlockSum& more) {
        for (size_t i = 0; i < sum.size(); ++i) sum[i] += more[i];
    };
    for (size_t r = 0; r < replicate_count; ++r)
        for (size_t i = 0; i < into.blocks[r].size(); ++i) {
            FilmBlock& block = into.blocks[r][i];
            const FilmBlock& more = from.blocks[r][i];
            for (size_t c = 0; c < 4; ++c) add(block.rgba[c], more.rgba[c]);
            for (const FarSum& f : more.far) add(sum_at(block, f.channel, f.level), f.sum);
            block.taken += more.taken;
        }
}

void merge(FilmCounters& into, const FilmCounters& from) {
    note(into.nonfinite, from.nonfinite);
    note(into.overflowed, from.overflowed);
}

}  // namespace drt
