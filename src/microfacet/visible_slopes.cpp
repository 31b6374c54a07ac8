#include "microfacet/visible_slopes.hpp"

#include <boost/math/special_functions/erf.hpp>

#include <algorithm>

namespace brdfplot {

double gaussian(double u) {
  const double above_0 = std::fmax(u, 0x1p-54);
  return u < 0.5 ? -boost::math::erfc_inv(2 * above_0) : boost::math::erfc_inv(2 * (1 - u));
}

double visible_gaussian(double c, double s, double u) {
  const double root_pi = std::sqrt(std::numbers::pi);
  const auto above = [&](double x) { return 0.5 * (c * root_pi * std::erfc(x) + s * std::exp(-x * x)); };
  double low = -std::fmin(9.0, s > 0 ? c / s : 9.0);
  // Seen from the horizon this is x itself, which rounding must not put beyond.
  double high = std::sqrt(-std::log1p(-u)) * (1 + 1e-12);
  const double target = (1 - u) * above(low);
  double x = std::clamp(s > 0 ? 0.5 * high : gaussian(u), low, high);
  for (int step = 0; step < 100 && high - low > 1e-15 * (1 + std::fabs(x)); ++step) {
    const double value = above(x);
    (value > target ? low : high) = x;
    const double slope = (c + s * x) * std::exp(-x * x);
    const double next = x + value / slope * std::log(value / target);
    const bool inside = next >= low && next <= high;
    const double moved = std::fabs(next - x);
    x = inside ? next : 0.5 * (low + high);
    if (inside && moved <= 1e-8 * (1 + std::fabs(x))) break; // the next step is the square of this one
  }
  return x;
}

} // namespace brdfplot
