#include "drt/sampling/inverse_cdf.h"

#include <array>
#include <cmath>
#include <utility>

namespace drt {
namespace {

using Density = std::function<double(double)>;

/// Gauss-Legendre with 5 nodes: exact for polynomials of degree 9.
double integrate(const Density& f, double a, double b) {
    constexpr double nodes[2] = {0.5384693101056830910363, 0.9061798459386639927976};
    constexpr double weights[3] = {0.5688888888888888888889, 0.4786286704993664680413, 0.2369268850561890875143};
    const double c = 0.5 * (a + b), h = 0.5 * (b - a);
    double sum = weights[0] * f(c);
    for (int i = 0; i < 2; ++i) sum += weights[i + 1] * (f(c - h * nodes[i]) + f(c + h * nodes[i]));
    return h * sum;
}

/// The upper end of a cell in v.
double cell_end(int cell) {
    const int octave = cell / InverseCdfs::cells_per_octave, step = cell % InverseCdfs::cells_per_octave;
    return std::ldexp(1.0 - step / (2.0 * InverseCdfs::cells_per_octave), -octave);
}

/// The x beyond which lies `mass`, by bisection within the panel that contains it. Panel i is
/// [i, i + 1] * length / panels and `beyond[i]` is the mass beyond its lower end.
double find_quantile(const Density& f, double length, const std::vector<double>& beyond, double mass) {
    const size_t panels = beyond.size() - 1;
    size_t i = panels - 1;
    while (i > 0 && beyond[i] < mass) --i;
    const double upper = length * double(i + 1) / double(panels);
    double lo = length * double(i) / double(panels), hi = upper;
    for (int k = 0; k < 60; ++k) {
        const double x = 0.5 * (lo + hi);
        (beyond[i + 1] + integrate(f, x, upper) > mass ? lo : hi) = x;
    }
    return 0.5 * (lo + hi);
}

/// The point below x with `mass` between them, by Newton's method: the slope is the density itself.
double step_down(const Density& f, double x, double mass) {
    double y = std::max(x - mass / f(x), 0.0);
    for (int k = 0; k < 8; ++k) {
        const double change = (integrate(f, y, x) - mass) / f(y);
        y = std::max(y + change, 0.0);
        if (std::abs(change) <= 1e-15 * x) break;
    }
    return y;
}

/// x at every cell's upper end. Walks from the far tail, where a small mass must be exact, to x = 0.
std::vector<double> quantiles(const Density& f, double length, double& total) {
    constexpr size_t panels = 256;
    std::vector<double> beyond(panels + 1);
    for (size_t i = panels; i-- > 0;)
        beyond[i] =
            beyond[i + 1] + integrate(f, length * double(i) / double(panels), length * double(i + 1) / double(panels));
    total = beyond[0];
    std::vector<double> x(InverseCdfs::cells);
    x.back() = find_quantile(f, length, beyond, total * cell_end(InverseCdfs::cells - 1));
    for (int cell = InverseCdfs::cells - 1; cell-- > 1;)
        x[size_t(cell)] = step_down(f, x[size_t(cell) + 1], total * (cell_end(cell) - cell_end(cell + 1)));
    x[0] = 0;
    return x;
}

}  // namespace

double append_inverse_cdf(InverseCdfs& tables, const Density& density, double length) {
    double total = 0;
    const std::vector<double> x = quantiles(density, length, total);
    for (int cell = 0; cell < InverseCdfs::cells; ++cell) {
        const double a = x[size_t(cell)];
        std::array<double, 4> c{a, 0, 0, 0};
        if (cell + 1 < InverseCdfs::cells) {
            const double width = cell_end(cell) - cell_end(cell + 1), rise = x[size_t(cell) + 1] - a;
            const double slope0 = width * total / density(a), slope1 = width * total / density(a + rise);
            c = {a, slope0, 3 * rise - 2 * slope0 - slope1, slope0 + slope1 - 2 * rise};
        }
        for (const double v : c) tables.coefficients.push_back(float(v));
    }
    return total;
}

void append_zero(InverseCdfs& tables) {
    tables.coefficients.resize(tables.coefficients.size() + 4 * size_t(InverseCdfs::cells), 0.0f);
}

}  // namespace drt
