#include "microfacet/smith_quadrature.hpp"

#include "math/atan_deficit.hpp"
#include "math/errors.hpp"
#include "math/interrupt.hpp"
#include "math/number.hpp"
#include "math/quadrature.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace brdfplot {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// t (t - a atan(t / a)).
double visible_excess(double a, double t) { return t * t * atan_deficit(t / a); }

/// The integrand over t, divided by a density near the largest one so that neither overflows nor vanishes.
class SmithIntegrand {
public:
  SmithIntegrand(const LogDensity& log_density, double a) : log_density_(log_density), a_(a), a2_(a * a) {
    const double here = log_density_(a2_);
    const double step = 1e-4 * (1 + a2_);
    const double fall = (here - log_density_(a2_ + step)) / step;
    // Where the density falls by a factor e; a guess that is wrong costs evaluations, no digits.
    scale_ = fall > 0 && fall < infinite ? std::clamp(1 / std::sqrt(fall), 1e-3, 2 * (1 + a)) : 1 + a;
    reference_ = here;
    if (!(fall > 0 && fall < infinite))
      for (int k = -40; k <= 40; ++k) reference_ = std::max(reference_, log_density_(a2_ + std::exp2(k)));
  }

  double scale() const { return scale_; }
  double reference() const { return reference_; }

  double operator()(double t) const {
    if (!(t < 1e150)) return 0;
    const double density = std::exp(log_density_(a2_ + t * t) - reference_);
    return density > 0 ? density * visible_excess(a_, t) : 0;
  }

private:
  const LogDensity& log_density_;
  double a_, a2_, scale_, reference_;
};

/// By a double exponential rule: around its mass the integrand is analytic in ln t on |Im ln t| < pi/2 whatever the
/// scales involved.
Estimate double_exponential(const SmithIntegrand& integrand) {
  thread_local boost::math::quadrature::exp_sinh<double> rule;
  double error = 0;
  double l1 = 0;
  const double scale = integrand.scale();
  const double value = rule.integrate([&](double v) { return scale * integrand(scale * v); }, 1e-11, &error, &l1);
  return {value, error, 0};
}

/// By bisection in ln t, for densities that are not analytic.
Estimate bisection(const SmithIntegrand& integrand) {
  const auto f = [&](const double* x, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) y[k] = std::exp(x[k]) * integrand(std::exp(x[k]));
  };
  const double middle = std::log(integrand.scale());
  const std::array<double, 10> cuts = {middle - 40, middle - 8, middle - 2, middle - 1,  middle,
                                       middle + 1,  middle + 2, middle + 8, middle + 40, middle + 345};
  return integrate(f, cuts, {.relative = 5e-11});
}

} // namespace

double a_lambda_by_quadrature(const LogDensity& log_density, double a) {
  throw_if_interrupted();
  if (a > 1e75) return 0;
  const SmithIntegrand integrand(log_density, a);
  // Below e^-2000 the result is 0 whatever the integral is, and the rounding of the logarithm leaves no digits of that.
  if (integrand.reference() < -2000) return 0;
  Estimate integral = double_exponential(integrand);
  if (!(integral.error <= 1e-10 * integral.value)) integral = bisection(integrand);
  if (!(integral.error <= 1e-10 * integral.value) && integral.value > 0)
    throw AccuracyError("lambda", "Smith's integral reached a relative error of " +
                                      format_number(integral.error / integral.value) +
                                      " only (asked: 1e-10) at a = " + format_number(a));
  return 2 * integral.value * std::exp(integrand.reference());
}

} // namespace brdfplot
