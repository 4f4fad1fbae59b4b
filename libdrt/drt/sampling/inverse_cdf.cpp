#include "drt/sampling/inverse_cdf.h"

#include <array>
#include <cmath>

#include "drt/sampling/tail_mass.h"

namespace drt {
namespace {

using Density = std::function<double(double)>;

/// The upper end of a cell in v.
double cell_end(int cell) {
    const int octave = cell / InverseCdfs::cells_per_octave, step = cell % InverseCdfs::cells_per_octave;
    return std::ldexp(1.0 - step / (2.0 * InverseCdfs::cells_per_octave), -octave);
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
std::vector<double> cell_quantiles(const TailMass& tail) {
    const double total = tail.total();
    std::vector<double> x(InverseCdfs::cells);
    x.back() = quantile(tail, total * cell_end(InverseCdfs::cells - 1));
    for (int cell = InverseCdfs::cells - 1; cell-- > 1;)
        x[size_t(cell)] = step_down(tail.density, x[size_t(cell) + 1], total * (cell_end(cell) - cell_end(cell + 1)));
    x[0] = 0;
    return x;
}

}  // namespace

double append_inverse_cdf(InverseCdfs& tables, const Density& density, double length) {
    const TailMass tail = tail_mass(density, length);
    const double total = tail.total();
    const std::vector<double> x = cell_quantiles(tail);
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
