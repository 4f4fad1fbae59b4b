#include "drt/dynamics/complementarity.h"

#include <algorithm>
#include <cmath>

namespace drt {

namespace {

constexpr int sweeps_between = 4;      // before which contacts hold is believed
constexpr int most_rounds = 5;         // those that have not settled then mostly never do
constexpr int most_corrections = 3;    // of a solution by pivoting
constexpr int most_direct_rows = 400;  // beyond it sweeps alone are cheaper
constexpr int most_sweeping_rounds = 20;
constexpr double dependent = 1e-11;  // of the diagonal: what is left of it
constexpr double exact = 1e-8;       // of the largest speed

void sweep(Complementarity& c) {
    for (int i = 0; i < c.n; ++i) {
        const double diagonal = c.at(i, i);
        if (diagonal > 0) c.x[size_t(i)] = std::clamp(c.x[size_t(i)] - c.w(i) / diagonal, c.low(i), c.high(i));
    }
}

// Cholesky in place, lower triangle; the right side becomes a solution. Unknowns that hang on those before them stay 0:
// four points hold a box where three would do.
void solve_semidefinite(std::vector<double>& m, std::vector<double>& y) {
    const size_t n = y.size();
    const auto row = [&](size_t i) { return &m[i * n]; };
    for (size_t i = 0; i < n; ++i) {
        for (size_t j = 0; j < i; ++j)
            row(i)[j] = (row(i)[j] - std::inner_product(row(i), row(i) + j, row(j), 0.0)) / row(j)[j];
        const double rest = row(i)[i] - std::inner_product(row(i), row(i) + i, row(i), 0.0);
        row(i)[i] = rest > dependent * row(i)[i] ? std::sqrt(rest) : std::numeric_limits<double>::infinity();
    }
    for (size_t i = 0; i < n; ++i) y[i] = (y[i] - std::inner_product(row(i), row(i) + i, y.begin(), 0.0)) / row(i)[i];
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; ++k) y[i] -= row(k)[i] * y[k];
        y[i] /= row(i)[i];
    }
}

// Normal impulses first, for they limit the friction.
void into_limits(Complementarity& c) {
    for (const bool normals : {true, false})
        for (int i = 0; i < c.n; ++i)
            if ((c.normal[size_t(i)] < 0) == normals) c.x[size_t(i)] = std::clamp(c.x[size_t(i)], c.low(i), c.high(i));
}

// All impulses between their limits at once, as if the others stayed as they are.
void solve_those_that_hold(Complementarity& c) {
    std::vector<int> free;
    std::vector<double> y;
    for (int i = 0; i < c.n; ++i)
        if (c.at(i, i) > 0 && c.x[size_t(i)] > c.low(i) && c.x[size_t(i)] < c.high(i)) {
            free.push_back(i);
            y.push_back(-c.w(i));
        }
    const size_t n = free.size();
    std::vector<double> m(n * n);
    for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j <= i; ++j) m[i * n + j] = c.at(free[i], free[j]);
    solve_semidefinite(m, y);
    for (size_t i = 0; i < n; ++i) c.x[size_t(free[i])] += y[i];
    into_limits(c);
}

}  // namespace

double residual(const Complementarity& c) {
    double largest = 0;
    for (int i = 0; i < c.n; ++i) {
        const double diagonal = c.at(i, i);
        if (diagonal <= 0) continue;
        const double better = std::clamp(c.x[size_t(i)] - c.w(i) / diagonal, c.low(i), c.high(i));
        largest = std::max(largest, std::abs(better - c.x[size_t(i)]) * diagonal);
    }
    return largest;
}

double solve(Complementarity& c) {
    double scale = 0;
    for (const double v : c.b) scale = std::max(scale, std::abs(v));
    const double enough = exact * scale;
    into_limits(c);
    std::vector<double> best = c.x;
    double least = residual(c);  // what held a moment ago may do
    const auto keep_if_better = [&] {
        const double error = residual(c);
        if (!(error < least)) return;
        least = error;
        best = c.x;
    };
    const bool direct = c.n <= most_direct_rows;
    for (int round = 0; round < (direct ? most_rounds : most_sweeping_rounds) && least > enough; ++round) {
        for (int k = 0; k < sweeps_between; ++k) sweep(c);
        if (direct) solve_those_that_hold(c);
        keep_if_better();
    }
    // What stops the pivoting, ties or rounding, depends on the perturbation.
    for (const double perturbation : {1e-10, 1e-8, 1e-6}) {
        if (!direct || least <= enough || !solve_by_pivoting(c, perturbation)) continue;
        keep_if_better();
        for (int round = 0; round < most_corrections && least > enough; ++round) {
            solve_those_that_hold(c);
            keep_if_better();
            for (int k = 0; k < 2; ++k) sweep(c);
            keep_if_better();
        }
    }
    c.x = best;
    return least;
}

}  // namespace drt
