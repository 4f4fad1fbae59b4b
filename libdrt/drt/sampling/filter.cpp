#include "drt/sampling/filter.h"

#include <algorithm>
#include <cmath>

#include "drt/base/constants.h"

namespace drt {
namespace {

double gaussian(double x, double sigma) {
    return std::exp(-x * x / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * pi<double>));
}

/// Harris, "On the use of windows for harmonic analysis", 1978: the four-term window. x in [-1, 1].
double blackman_harris(double x) {
    const double t = pi<double> * (x + 1);
    return 0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
}

/// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988, B = C = 1/3. Outside 1 it factors as
/// -7/18 (x - 2)^2 (x - 8/7): negative beyond 8/7, lowest at 10/7.
double mitchell(double x) {
    x = std::abs(x);
    if (x < 1) return (7 * x * x * x - 12 * x * x + 16.0 / 3) / 6;
    return x < 2 ? -7.0 / 18 * (x - 2) * (x - 2) * (x - 8.0 / 7) : 0;
}

struct Stretch {
    double start, end;  ///< in pixels; |f| is sampled from start towards end
};

/// Pieces of the half line in the order of their distance from the centre. Where |f| is zero at a piece's end, the
/// inverse CDF is singular there, which the table resolves at its end only: so a negative lobe is cut at its lowest
/// point.
std::vector<Stretch> stretches(const FilterSpec& spec) {
    if (spec.kind == FilterKind::gaussian) return {{0, std::min(spec.radius, 9.5 * spec.sigma)}};
    if (spec.kind == FilterKind::blackman_harris) return {{0, spec.radius}};
    const double s = spec.radius / 2;
    return {{0, 8.0 / 7 * s}, {10.0 / 7 * s, 8.0 / 7 * s}, {10.0 / 7 * s, 2 * s}};
}

void tabulate(FilterTable& filter) {
    double absolute = 0, net = 0;
    std::vector<double> masses;
    for (const auto& [start, end] : stretches(filter.spec)) {
        FilterPiece piece;
        piece.start = float(start);
        piece.direction = end > start ? 1.0f : -1.0f;
        piece.sign = filter_value(filter.spec, start) < 0 ? -1.0f : 1.0f;
        const TailMass tail = tail_mass(
            [&, start = start](double x) { return std::abs(filter_value(filter.spec, start + piece.direction * x)); },
            std::abs(end - start));
        piece.quantiles = octave_quantiles(tail);
        masses.push_back(tail.total());
        absolute += masses.back();
        net += masses.back() * piece.sign;
        filter.pieces.push_back(piece);
    }
    double before = 0;
    for (size_t i = 0; i < masses.size(); before += masses[i], ++i) {
        FilterPiece& p = filter.pieces[i];
        p.from = float(before / absolute);
        const double slope = absolute / masses[i];  // v falls away from the start
        p.v1 = float(-p.direction * slope);
        p.v0 = float((p.direction > 0 ? 1 : 0) + p.direction * before / masses[i]);
    }
    filter.absolute_integral = 2 * absolute;
    filter.integral = 2 * net;
    filter.weight = float(absolute / net);
}

}  // namespace

double filter_value(const FilterSpec& spec, double x) {
    if (std::abs(x) > spec.radius) return 0;
    switch (spec.kind) {
        case FilterKind::point:
            return 0;
        case FilterKind::box:
            return 1;
        case FilterKind::triangle:
            return 1 - std::abs(x) / spec.radius;
        case FilterKind::gaussian:
            return gaussian(x, spec.sigma);
        case FilterKind::blackman_harris:
            return blackman_harris(x / spec.radius);
        case FilterKind::mitchell:
            return mitchell(2 * x / spec.radius);
    }
    return 0;
}

FilterTable make_filter(const FilterSpec& spec) {
    FilterTable filter;
    filter.spec = spec;
    switch (spec.kind) {
        case FilterKind::point:
            break;
        case FilterKind::box:
            filter.integral = filter.absolute_integral = 2 * spec.radius;
            break;
        case FilterKind::triangle:
            filter.integral = filter.absolute_integral = spec.radius;
            break;
        default:
            tabulate(filter);
    }
    return filter;
}

}  // namespace drt
