#pragma once
// Statistical tests with a stated confidence, after Mitsuba's and pbrt's chi^2 tests of samplers.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "drt/base/math.h"

namespace drt::test {

/// The upper tail probability of the standard normal distribution.
inline double normal_tail(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }

/// The probability that a chi^2 variable with `dof` degrees of freedom exceeds `x`: Wilson and Hilferty's cube-root
/// approximation, good to three digits for the dof >= 30 used here.
inline double chi2_tail(double x, double dof) {
    const double v = 2.0 / (9.0 * dof);
    return normal_tail((std::cbrt(x / dof) - (1.0 - v)) / std::sqrt(v));
}

/// The p-value of observed counts against expected ones; bins that expect fewer than 5 are pooled. A count in a bin
/// that expects nothing gives 0.
inline double chi2_p_value(const std::vector<double>& observed, const std::vector<double>& expected) {
    double sum = 0, pooled_observed = 0, pooled_expected = 0;
    int cells = 0;
    const auto add = [&](double o, double e) {
        sum += (o - e) * (o - e) / e;
        ++cells;
    };
    for (size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] == 0 && observed[i] > 0) return 0;
        if (expected[i] < 5) {
            pooled_observed += observed[i];
            pooled_expected += expected[i];
        } else {
            add(observed[i], expected[i]);
        }
    }
    if (pooled_expected >= 5) add(pooled_observed, pooled_expected);
    return cells < 2 ? 0 : chi2_tail(sum, cells - 1);
}

/// The level of one of `tests` tests so that all of them together have level `alpha` (Sidak).
inline double sidak(double alpha, int tests) { return 1.0 - std::pow(1.0 - alpha, 1.0 / tests); }

/// The p-value of a million points (u, v) = point(i) that ought to be uniform in [0, 1]^2, in 80 x 160 bins. What
/// follows another density goes through its CDFs first.
template <class F>
double uniformity(const F& point) {
    constexpr int samples = 1000000, columns = 80, rows = 160;
    std::vector<double> counts(size_t(columns * rows));
    const std::vector<double> expected(counts.size(), double(samples) / double(counts.size()));
    for (std::uint32_t i = 0; i < samples; ++i) {
        const auto p = point(i);
        const int column = std::clamp(int(p.x * columns), 0, columns - 1);
        const int row = std::clamp(int(p.y * rows), 0, rows - 1);
        counts[size_t(column * rows + row)] += 1;
    }
    return chi2_p_value(counts, expected);
}

/// The direction of (x, y) in turns, in [0, 1). In float, to 3 ulp: a hundred thousand times finer than any bin.
inline double turn_of(double y, double x) {
    const float t = fast_atan2(float(y), float(x)) * float(0.5 / std::numbers::pi);
    return t < 0 ? t + 1 : t;
}

/// Mean and its standard error of independent values.
struct Mean {
    double sum = 0, sum2 = 0, n = 0;
    void add(double v) {
        sum += v;
        sum2 += v * v;
        n += 1;
    }
    double mean() const { return sum / n; }
    double variance() const { return (sum2 - sum * sum / n) / (n - 1); }
    double error() const { return std::sqrt(variance() / n); }
};

}  // namespace drt::test
