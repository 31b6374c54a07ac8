#include "microfacet/distributions/inverse_gaussian.hpp"

#include <boost/math/special_functions/bessel.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace brdfplot {

namespace {

/// (L(x) - 1) / x = - sum_(n >= 1) (-1/2)_n / n!^2 (-x)^(n - 1), 0 <= x <= 1: it alternates from 1/2 on.
double series(double x) {
  double term = 0.5;
  double sum = 0;
  for (int n = 1; std::fabs(term) > 1e-17; ++n) {
    sum += term;
    term *= -x * (n - 0.5) / ((n + 1.0) * (n + 1.0));
  }
  return sum;
}

/// L(1 / a^2) a sqrt(pi) / 2 = sum (-1/2)_n^2 / n! a^2n, asymptotic: the terms are below e^(-1 / a^2) before they grow.
double asymptotic(double a2) {
  double term = 1;
  double sum = 0;
  for (int n = 0; term > 1e-17; ++n) {
    sum += term;
    term *= (n - 0.5) * (n - 0.5) / (n + 1.0) * a2;
  }
  return sum;
}

} // namespace

double InverseGaussianShape::density(double t2) {
  const double numerator = std::exp(-1 / t2);
  return numerator > 0 ? numerator * std::numbers::inv_pi / (t2 * t2) : 0;
}

double InverseGaussianShape::scaled_density(double n2, double z2) {
  const double numerator = std::exp(-z2 / n2);
  return numerator > 0 ? numerator * std::numbers::inv_pi / (n2 * n2) : 0;
}

double InverseGaussianShape::a_lambda(double a) {
  if (a > 1) return 0.5 * series(1 / (a * a)) / a;
  if (a < 0.125) return std::numbers::inv_sqrtpi * asymptotic(a * a) - 0.5 * a;
  const double x = 1 / (a * a);
  const double h = 0.5 * x;
  const double whole = std::exp(-h) * ((1 + x) * boost::math::cyl_bessel_i(0, h) + x * boost::math::cyl_bessel_i(1, h));
  return 0.5 * a * (whole - 1);
}

} // namespace brdfplot
