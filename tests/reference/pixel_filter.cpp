#include "reference/pixel_filter.h"

namespace drt::reference {
namespace {

/// Mitchell and Netravali 1988 with B = C = 1/3, support [-2, 2].
double mitchell(double x) {
    constexpr double b = 1.0 / 3, c = 1.0 / 3;
    const double x2 = x * x, x3 = x2 * x;
    if (x < 1) return ((12 - 9 * b - 6 * c) * x3 + (-18 + 12 * b + 6 * c) * x2 + (6 - 2 * b)) / 6;
    return ((-b - 6 * c) * x3 + (6 * b + 30 * c) * x2 + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
}

/// The four-term window (Harris 1978) stretched over [-radius, radius].
double blackman_harris(double x, double radius) {
    const double phase = std::numbers::pi * (x / radius + 1);
    return 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2 * phase) - 0.01168 * std::cos(3 * phase);
}

}  // namespace

double filter_value(const Filter& filter, double x) {
    x = std::abs(x);
    if (x > filter.radius) return 0;
    switch (filter.kind) {
        case Filter::Kind::point:
        case Filter::Kind::box:
            return 1;
        case Filter::Kind::triangle:
            return 1 - x / filter.radius;
        case Filter::Kind::gaussian:
            return std::exp(-x * x / (2 * filter.sigma * filter.sigma));
        case Filter::Kind::blackman_harris:
            return blackman_harris(x, filter.radius);
        case Filter::Kind::mitchell:
            return mitchell(2 * x / filter.radius) / mitchell(0);
    }
    return 0;
}

PixelFilter::PixelFilter(const Filter& filter) : filter_(filter) {
    if (filter.kind != Filter::Kind::mitchell) return;  // the only one with negative values
    double sum = 0, absolute = 0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
        const double value = filter_value(filter, filter.radius * (i + 0.5) / steps);
        sum += value;
        absolute += std::abs(value);
    }
    magnitude_ = absolute / sum;
}

double PixelFilter::sample_axis(Random& random, double& weight) const {
    for (;;) {
        const double x = random.between(-filter_.radius, filter_.radius);
        const double value = filter_value(filter_, x);
        if (random.uniform() >= std::abs(value)) continue;
        weight *= value < 0 ? -magnitude_ : magnitude_;
        return x;
    }
}

PixelFilter::Sample PixelFilter::sample(Random& random) const {
    Sample sample;
    if (filter_.kind == Filter::Kind::point) return sample;
    sample.offset.x = sample_axis(random, sample.weight);
    sample.offset.y = sample_axis(random, sample.weight);
    return sample;
}

}  // namespace drt::reference
