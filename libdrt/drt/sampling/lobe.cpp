#include "drt/sampling/lobe.h"

#include <algorithm>
#include <cmath>

namespace drt {
namespace {

double unnormalised(double theta, double sigma) {
    const double x = theta / sigma;
    return std::exp(-0.5 * x * x) * std::cos(theta);
}

}  // namespace

int add_lobe(LobeTables& tables, double sigma) {
    const auto known = std::find(tables.sigma.begin(), tables.sigma.end(), sigma);
    if (known != tables.sigma.end()) return int(known - tables.sigma.begin());
    if (sigma == 0) {
        append_zero(tables.inverse);
        tables.integral.push_back(0);
    } else {
        // A Gaussian holds less than 1e-20 beyond 9.5 sigma: nothing at 32 bits.
        const double length = std::min(pi<double> / 2, 9.5 * sigma);
        tables.integral.push_back(append_inverse_cdf(
            tables.inverse, [sigma](double t) { return unnormalised(t, sigma); }, length));
    }
    tables.sigma.push_back(sigma);
    tables.falloff.push_back(sigma == 0 ? 0.0f : float(-0.5 / (sigma * sigma)));
    tables.scale.push_back(sigma == 0 ? 0.0f : float(1 / (2 * pi<double> * tables.integral.back())));
    return int(tables.sigma.size()) - 1;
}

double lobe_pdf_theta(const LobeTables& tables, int lobe, double theta) {
    const double sigma = tables.sigma[size_t(lobe)];
    return theta < 0 || theta >= pi<double> / 2 ? 0 : unnormalised(theta, sigma) / tables.integral[size_t(lobe)];
}

double lobe_pdf(const LobeTables& tables, int lobe, double theta) {
    return lobe_pdf_theta(tables, lobe, theta) / (2 * pi<double> * std::sin(theta));
}

}  // namespace drt
