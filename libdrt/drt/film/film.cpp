#include "drt/film/film.h"

#include <algorithm>
#include <cmath>

namespace drt {

Film::Film(int w, int h) : width(w), height(h) {
    for (auto& s : sums) s.resize(size_t(w) * size_t(h));
}

void add_sample(Film& film, std::uint32_t sample, int x, int y, const std::array<float, 4>& rgba,
                FilmCounters& counters) {
    // One test for all four: a sum is finite only if every term is (inf - inf is NaN), up to overflow, which the
    // clamp below would have to count anyway.
    const float largest =
        std::max(std::max(std::abs(rgba[0]), std::abs(rgba[1])), std::max(std::abs(rgba[2]), std::abs(rgba[3])));
    const float check = rgba[0] + rgba[1] + rgba[2] + rgba[3];
    std::array<float, 4> value = rgba;
    if (!(largest <= sample_limit) || std::isnan(check)) {
        if (!std::all_of(rgba.begin(), rgba.end(), [](float v) { return std::isfinite(v); })) {
            if (counters.nonfinite++ == 0) {
                counters.first_nonfinite_x = x;
                counters.first_nonfinite_y = y;
                counters.first_nonfinite_sample = sample;
            }
            return;
        }
        ++counters.clamped;
        for (float& v : value) v = std::clamp(v, -sample_limit, sample_limit);
    }
    PixelSum& sum = film.sums[size_t(replicate_of(sample))][size_t(y) * size_t(film.width) + size_t(x)];
    for (size_t c = 0; c < 4; ++c) sum.rgba[c] += std::int64_t(std::nearbyint(double(value[c]) * fixed_point_scale));
    ++sum.samples;
}

void merge(FilmCounters& into, const FilmCounters& from) {
    if (into.nonfinite == 0 && from.nonfinite > 0) {
        into.first_nonfinite_x = from.first_nonfinite_x;
        into.first_nonfinite_y = from.first_nonfinite_y;
        into.first_nonfinite_sample = from.first_nonfinite_sample;
    }
    into.nonfinite += from.nonfinite;
    into.clamped += from.clamped;
}

namespace {

float mean(std::int64_t sum, std::uint64_t samples) {
    return samples == 0 ? 0.0f : float(double(sum) / (fixed_point_scale * double(samples)));
}

}  // namespace

Image resolve(const Film& film) {
    Image out(film.width, film.height, 4);
    for (size_t i = 0; i < film.sums[0].size(); ++i) {
        const PixelSum &a = film.sums[0][i], &b = film.sums[1][i];
        const std::uint64_t n = std::uint64_t(a.samples) + b.samples;
        for (size_t c = 0; c < 4; ++c) out.data[4 * i + c] = mean(a.rgba[c] + b.rgba[c], n);
    }
    return out;
}

Image resolve(const Film& film, int replicate) {
    Image out(film.width, film.height, 4);
    const auto& sums = film.sums[size_t(replicate)];
    for (size_t i = 0; i < sums.size(); ++i)
        for (size_t c = 0; c < 4; ++c) out.data[4 * i + c] = mean(sums[i].rgba[c], sums[i].samples);
    return out;
}

ErrorEstimate estimate_error(const Film& film) {
    double squared_error = 0, squared_value = 0;
    const size_t pixels = film.sums[0].size();
    for (size_t i = 0; i < pixels; ++i) {
        const PixelSum &a = film.sums[0][i], &b = film.sums[1][i];
        if (a.samples == 0 || b.samples == 0) return {};
        const double na = a.samples, nb = b.samples;
        for (size_t c = 0; c < 3; ++c) {
            const double ma = double(a.rgba[c]) / (fixed_point_scale * na),
                         mb = double(b.rgba[c]) / (fixed_point_scale * nb);
            // Var of the weighted mean of two independent means whose variances go as 1/n: (ma - mb)^2 na nb / (na +
            // nb)^2
            squared_error += (ma - mb) * (ma - mb) * na * nb / ((na + nb) * (na + nb));
            const double m = (na * ma + nb * mb) / (na + nb);
            squared_value += m * m;
        }
    }
    ErrorEstimate e;
    e.rmse = std::sqrt(squared_error / (3.0 * double(pixels)));
    e.relative = squared_value > 0 ? std::sqrt(squared_error / squared_value) : 0;
    e.valid = pixels > 0;
    return e;
}

}  // namespace drt
