#pragma once
// Exact quantiles of a density on [0, length], from the mass *beyond* x, so that they are exact in the tail too.

#include <functional>
#include <vector>

namespace drt {

/// Gauss-Legendre with 5 nodes: exact for polynomials of degree 9.
double integrate(const std::function<double(double)>& f, double a, double b);

struct TailMass {
    std::function<double(double)> density;  ///< need not be normalised; smooth and positive on (0, length)
    double length = 0;
    std::vector<double> beyond;  ///< the mass beyond the lower end of each panel of length / (size - 1); 0 at the end
    double total() const { return beyond.front(); }
};

TailMass tail_mass(std::function<double(double)> density, double length);

/// The x beyond which lies `mass`, in [0, total]. Absolute error below 1e-15 of the length.
double quantile(const TailMass&, double mass);

}  // namespace drt
