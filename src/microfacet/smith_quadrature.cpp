#include "microfacet/smith_quadrature.hpp"

#include "math/errors.hpp"
#include "math/number.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>

#include <cmath>

namespace brdfplot {

namespace {

/// s - atan s, by its series where the difference cancels (relative error < 4e-16 there).
double s_minus_atan(double s) {
  if (s > 0.35) return s - std::atan(s);
  const double s2 = s * s;
  double term = s * s2;
  double sum = 0;
  for (int k = 3; k <= 37; k += 2) {
    sum += term / k;
    term *= -s2;
  }
  return sum;
}

} // namespace

double mu_lambda_by_quadrature(const std::function<double(double)>& log_p22_of_r2, double mu, double scale) {
  if (mu > 1e75) return 0;
  thread_local boost::math::quadrature::exp_sinh<double> rule;
  const double log_p22_of_mu2 = log_p22_of_r2(mu * mu);
  // Around its mass the integrand is analytic in log s on |Im log s| < pi/2 whatever the scales involved, which is what
  // a double exponential rule wants.
  const auto integrand = [&](double v) {
    const double s = scale * v;
    if (!(s < 1e150)) return 0.0;
    const double density = std::exp(log_p22_of_r2(mu * mu * (1 + s * s)) - log_p22_of_mu2);
    return density > 0 ? density * s * s_minus_atan(s) * scale : 0.0;
  };
  double error = 0;
  double l1 = 0;
  const double integral = rule.integrate(integrand, 1e-11, &error, &l1);
  if (!(error <= 1e-10 * l1) && l1 > 0)
    throw AccuracyError("lambda", "Smith's integral reached a relative error of " + format_number(error / l1) +
                                      " only (asked: 1e-10) at cot theta = " + format_number(mu));
  return 2 * mu * mu * mu * integral * std::exp(log_p22_of_mu2);
}

} // namespace brdfplot
