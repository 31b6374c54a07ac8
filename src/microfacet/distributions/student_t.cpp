#include "microfacet/distributions/student_t.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <algorithm>
#include <numbers>

namespace brdfplot {

namespace {

/// 2F1(excess, 1; 1/2; x) for x within [0, 0.75]: all terms are positive.
double gauss_series(double excess, double x) {
  double sum = 1, term = 1;
  for (int n = 0;; ++n) {
    const double ratio = (excess + n) * x / (n + 0.5);
    term *= ratio;
    sum += term;
    // The ratio of the terms goes to x, and to one side only.
    const double largest = std::max(ratio, x);
    if (largest < 1 && term * largest <= 0x1p-54 * (1 - largest) * sum) return sum;
  }
}

/// a^2 T of Gauss's continued fraction 2F1(1/2, 1; g + 1; -g / a^2) = 1 / (1 + k_1 g / (a^2 T)), a >= 1.1:
/// a^2 + k_2 g / (1 + k_3 g / (a^2 + k_4 g / (1 + ...))), k_2n = n (g + n - 1/2) / ((g + 2n - 1) (g + 2n)),
/// k_2n+1 = (n + 1/2) (g + n) / ((g + 2n) (g + 2n + 1)).
double gauss_tail(double g, double a2) {
  // Slowest for g -> infinity, where it is that of erfc: exp(-4 a sqrt(n)) after n pairs, which few pairs have not
  // reached yet.
  const int pairs = 6 + static_cast<int>(108 / a2);
  double tail = a2;
  for (int n = pairs; n > 0; --n) {
    const double middle = g + 2 * n, over = g / middle;
    const double odd = (n + 0.5) * (g + n) / (middle + 1) * over;
    const double even = n * (g + n - 0.5) / (middle - 1) * over;
    tail = a2 + even * tail / (tail + odd);
  }
  return tail;
}

} // namespace

ModelSpec StudentTShape::about() {
  return {.type = "student_t",
          .doc = "Student's t distributed slopes: gamma = 2 is GGX, gamma to infinity Beckmann",
          .source = "Ribardiere et al. 2017, Eqs. 6-13; Lambda exact by the incomplete beta function",
          .parameters = {{.key = "gamma",
                          .bounds = {.min = 1.5, .max = 1e15, .open_min = true},
                          .doc = "exponent of the tail, slopes fall like t^(-2 gamma)"}}};
}

StudentTShape StudentTShape::of_excess(double excess) {
  const double g = excess + 0.5;
  return {g + 1, excess, std::sqrt(g * std::numbers::inv_pi) / (boost::math::tgamma_delta_ratio(g, 0.5) * 2 * excess)};
}

double StudentTShape::density(double t2) const {
  return std::numbers::inv_pi * std::exp(-gamma * std::log1p(t2 / (gamma - 1)));
}

double StudentTShape::scaled_density(double n2, double z2) const {
  const double z2_above = std::max(z2, 1e-300);
  return std::numbers::inv_pi * std::exp(-gamma * std::log1p(n2 / ((gamma - 1) * z2_above)) - 2 * std::log(z2_above));
}

double StudentTShape::a_lambda(double a) const {
  const double g = gamma - 1;
  const double a2 = a * a;
  const double log_w = a < 1e150 ? -std::log1p(a2 / g) : std::log(g) - 2 * std::log(a);
  const double whole = scale * std::exp(excess * log_w);
  if (a < 1.1) return whole * gauss_series(excess, a2 / (g + a2)) - 0.5 * a;
  const double tail = gauss_tail(g, std::min(a2, 1e280));
  const double first = g / (g + 1);
  return whole * 0.5 * (tail / g + first) / (tail + 0.5 * first);
}

} // namespace brdfplot
