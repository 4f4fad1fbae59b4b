#include "drt/film/error_estimate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drt/film/block_total.h"

namespace drt {

namespace {

// Over the pixels of a picture.
struct Sums {
    double squared_error = 0, squared_error_squared = 0;  // of a pixel: the mean of its channels
    double squared_value = 0;
    double fewest = std::numeric_limits<double>::infinity();  // samples of a pixel
    bool complete = true;                                     // both replicates have samples everywhere
};

Sums sum_up(const Film& film) {
    Sums sums;
    for_each_block(film, [&](size_t block, int x0, int y0) {
        const BlockTotal a = total_of(film.blocks[0][block]), b = total_of(film.blocks[1][block]);
        if (a.taken == 0 || b.taken == 0) {
            sums.complete = false;
            return;
        }
        // Two independent means whose variances go as 1/n: the variance of their weighted mean is
        // (a - b)^2 na nb / (na + nb)^2 in expectation.
        const double n = a.taken + b.taken, weight = a.taken * b.taken / (n * n);
        sums.fewest = std::min(sums.fewest, n);
        for_each_pixel(film, x0, y0, [&](size_t i, int, int) {
            double squares = 0;
            for (size_t c = 0; c < 3; ++c) {
                const double difference = a.rgba[c][i] / a.taken - b.rgba[c][i] / b.taken;
                const double value = (a.rgba[c][i] + b.rgba[c][i]) / n;
                squares += difference * difference * weight / 3;
                sums.squared_value += value * value / 3;
            }
            sums.squared_error += squares;
            sums.squared_error_squared += squares * squares;
        });
    });
    return sums;
}

// The degrees of freedom that the squared error rests on: those of normal differences of equal size, one a pixel, whose
// squares would scatter as these do (after Satterthwaite 1946).
double freedom(const Sums& s) { return 3 * s.squared_error * s.squared_error / s.squared_error_squared; }

// By so much a single sample of the brightest that there is, in a single pixel, would raise the squared error.
double one_more_sample(const Sums& s, const SceneLimits& scene) {
    return scene.brightest * scene.brightest / (s.fewest * s.fewest);
}

constexpr double least_freedom = 16, samples_that_must_not_matter = 4;

bool is_lower_bound(const Sums& s, const SceneLimits& scene) {
    if (s.squared_error == 0) return scene.random;
    return freedom(s) < least_freedom || s.squared_error < samples_that_must_not_matter * one_more_sample(s, scene);
}

}  // namespace

ErrorEstimate estimate_error(const Film& film, const SceneLimits& scene) {
    ErrorEstimate e;
    if (film.width == 0 || film.height == 0) return e;
    const Sums s = sum_up(film);
    if (!s.complete) return e;
    e.valid = true;
    e.rmse = std::sqrt(s.squared_error / (double(film.width) * film.height));
    e.relative = s.squared_value > 0 ? std::sqrt(s.squared_error / s.squared_value) : 0;
    e.freedom = s.squared_error > 0 ? freedom(s) : 0;
    e.at_least = is_lower_bound(s, scene);
    return e;
}

}  // namespace drt
