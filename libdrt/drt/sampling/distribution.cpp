#include "drt/sampling/distribution.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "drt/base/diagnostic.h"

namespace drt {
namespace {

constexpr double grid = 0x1p24;

/// Whole units out of 2^24, proportional to the weights up to rounding, at least 1 for a positive weight. One unit goes
/// to each positive weight first; the rest is cut by the rounded running sum, so that rounding never accumulates.
std::vector<std::int64_t> apportion(std::span<const double> weights) {
    double total = 0;
    std::int64_t positive = 0;
    for (const double w : weights) {
        if (!(w >= 0) || !std::isfinite(w))
            throw Error(ErrorKind::internal, "distribution: weights must be finite, >= 0");
        total += w;
        positive += w > 0;
    }
    if (!(total > 0) || !std::isfinite(total)) throw Error(ErrorKind::internal, "distribution: no positive weight");
    const double rest = grid - double(positive);
    std::vector<std::int64_t> units(weights.size());
    double running = 0;
    std::int64_t given = 0;
    for (size_t i = 0; i < weights.size(); ++i) {
        if (weights[i] == 0) continue;
        running += weights[i];
        const auto upto = std::int64_t(std::llround(std::min(running / total, 1.0) * rest));
        units[i] = 1 + (upto - given);
        given = upto;
    }
    return units;
}

}  // namespace

Distribution make_distribution(std::span<const double> weights) {
    const size_t n = weights.size();
    if (n == 0 || n > size_t(1) << 22) throw Error(ErrorKind::internal, "distribution: 1 to 2^22 weights");
    Distribution d;
    d.cdf.assign(n + 1, 0.0f);
    std::int64_t sum = 0;
    const std::vector<std::int64_t> units = apportion(weights);
    for (size_t i = 0; i < n; ++i) d.cdf[i + 1] = float(double(sum += units[i]) / grid);

    // A power of two of buckets, so that u * buckets is exact.
    const size_t buckets = std::bit_ceil(n);
    d.guide.resize(buckets + 1);
    for (size_t b = 0; b <= buckets; ++b) {
        const auto after = std::upper_bound(d.cdf.begin(), d.cdf.end(), float(b) / float(buckets));
        d.guide[b] = std::int32_t(std::min(size_t(after - d.cdf.begin()), n)) - 1;
    }
    int widest = 0;
    for (size_t b = 0; b < buckets; ++b) widest = std::max(widest, d.guide[b + 1] - d.guide[b]);
    d.steps = int(std::bit_width(unsigned(widest)));
    return d;
}

}  // namespace drt
