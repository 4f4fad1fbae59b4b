#include "drt/sampling/tail_mass.h"

#include <utility>

namespace drt {

double integrate(const std::function<double(double)>& f, double a, double b) {
    constexpr double nodes[2] = {0.5384693101056830910363, 0.9061798459386639927976};
    constexpr double weights[3] = {0.5688888888888888888889, 0.4786286704993664680413, 0.2369268850561890875143};
    const double c = 0.5 * (a + b), h = 0.5 * (b - a);
    double sum = weights[0] * f(c);
    for (int i = 0; i < 2; ++i) sum += weights[i + 1] * (f(c - h * nodes[i]) + f(c + h * nodes[i]));
    return h * sum;
}

namespace {

constexpr std::size_t panels = 256;

double panel_start(const TailMass& t, std::size_t i) { return t.length * double(i) / double(panels); }

}  // namespace

TailMass tail_mass(std::function<double(double)> density, double length) {
    TailMass t{std::move(density), length, std::vector<double>(panels + 1)};
    for (std::size_t i = panels; i-- > 0;)
        t.beyond[i] = t.beyond[i + 1] + integrate(t.density, panel_start(t, i), panel_start(t, i + 1));
    return t;
}

double quantile(const TailMass& t, double mass) {
    std::size_t i = panels - 1;
    while (i > 0 && t.beyond[i] < mass) --i;
    const double upper = panel_start(t, i + 1);
    double lo = panel_start(t, i), hi = upper;
    for (int k = 0; k < 60; ++k) {  // bisection within the panel
        const double x = 0.5 * (lo + hi);
        (t.beyond[i + 1] + integrate(t.density, x, upper) > mass ? lo : hi) = x;
    }
    return 0.5 * (lo + hi);
}

}  // namespace drt
