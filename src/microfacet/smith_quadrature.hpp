/// \file
/// Smith's Lambda of any isotropic distribution of slopes, by quadrature.
#pragma once

#include <cstddef>
#include <functional>

namespace brdfplot {

/// mu Lambda(mu), mu = cot theta_o, for an isotropic slope density P22(r):
///   Lambda(mu) = 2 mu^2 int_0^inf P22(mu sqrt(1 + s^2)) s (s - atan s) ds,
/// Heitz 2014, Eqs. 40-43 in polar slopes r = mu sqrt(1 + s^2); every term is positive, so nothing cancels.
/// The density is given as ln P22 of r^2, so that a Lambda of 1e-300 has as many digits as one of 1.
/// `scale` is where the integrand has its mass in s (any value works; a good one costs fewer points).
/// Domain mu > 0, P22 r^2 integrable over r. Relative error about 1e-13; 0 from mu = 1e75 on, where Lambda < 1e-149 and
/// mu^3 would overflow soon.
/// \throws AccuracyError when the estimate is not below 1e-10.
double mu_lambda_by_quadrature(const std::function<double(double r2)>& log_p22_of_r2, double mu, double scale);

/// masked_area() of n projections; an integral is not computed twice in a row, since many rows share one direction.
template <class D>
void masked_areas_by_quadrature(const D& distribution, const double* c, const double* s, double* t, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    const bool repeated = k > 0 && c[k] == c[k - 1] && s[k] == s[k - 1];
    t[k] = repeated ? t[k - 1] : distribution.masked_area({c[k], s[k]});
  }
}

} // namespace brdfplot
