#pragma once
// The problem behind bodies that hold each other: impulses x and the speeds w = A x + b that they leave, such that
// each impulse is within its limits, and only those at a limit leave a speed, which the limit is in the way of:
//     low < x < high: w = 0;    x = low: w >= 0;    x = high: w <= 0.
// A normal impulse has the limits 0 and infinity; friction is within a multiple of the normal impulse it belongs to.

#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace drt {

struct Complementarity {
    int n = 0;
    std::vector<double> A;    ///< n x n, symmetric, positive semidefinite; a diagonal of 0: nothing moves
    std::vector<double> b;    ///< length / s
    std::vector<double> x;    ///< where the solution begins
    std::vector<int> normal;  ///< by row: -1 for normal impulses, or the row of the one that limits it
    std::vector<double> limit;

    double at(int i, int j) const { return A[std::size_t(i) * std::size_t(n) + std::size_t(j)]; }
    double high(int i) const {
        return normal[std::size_t(i)] < 0 ? std::numeric_limits<double>::infinity()
                                          : limit[std::size_t(i)] * x[std::size_t(normal[std::size_t(i)])];
    }
    double low(int i) const { return normal[std::size_t(i)] < 0 ? 0 : -high(i); }
    double w(int i) const {
        const double* row = &A[std::size_t(i) * std::size_t(n)];
        return std::inner_product(row, row + n, x.begin(), b[std::size_t(i)]);
    }
};

/// How far x is from a solution, as a speed.
double residual(const Complementarity&);

/// Sweeps that find which impulses are between their limits and a direct solution for those (projected Gauss-Seidel
/// with subspace minimisation, Silcowitz, Niebe and Erleben 2010); what does not settle so by Lemke's method. Returns
/// the residual that is left: mostly 1e-8 of the largest speed in b.
double solve(Complementarity&);

/// Exchanges basic variables one by one (Lemke 1965) in the form in which a solution always exists and is found, but
/// for rounding (Anitescu and Potra 1997). Whatever x was does not matter. `perturbation`, of the largest speed in b,
/// breaks ties, and is an error of the solution. False: stopped, and x is as it was.
bool solve_by_pivoting(Complementarity&, double perturbation);

}  // namespace drt
