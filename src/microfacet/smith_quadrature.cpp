#include "microfacet/smith_quadrature.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "base/threads/interrupt.hpp"
#include "math/atan_deficit.hpp"
#include "math/quadrature.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace brdfplot {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double far = 1e30;          ///< squared slope where a tail has become a power
constexpr double slowest = 1.65;      ///< power of a tail that the rule itself takes to its end
constexpr double negligible = 1e-200; ///< error of a Lambda that nobody sees in G1

/// t (t - a atan(t / a)).
double visible_excess(double a, double t) { return t * t * atan_deficit(t / a); }

/// The integrand over t, divided by a density near the largest one so that neither overflows nor vanishes.
class SmithIntegrand {
public:
  SmithIntegrand(const LogDensity& log_density, double a, const DensityHints& hints)
      : log_density_(log_density), a_(a), a2_(a * a) {
    const double here = log_density_(a2_);
    const double step = 1e-4 * (1 + a2_);
    const double fall = (here - log_density_(a2_ + step)) / step;
    // Where the density falls by a factor e; a guess that is wrong costs evaluations, no digits.
    scale_ = fall > 0 && fall < infinite ? std::clamp(1 / std::sqrt(fall), 1e-3, 2 * (1 + a)) : 1 + a;
    reference_ = here;
    if (!(fall > 0 && fall < infinite))
      for (int k = -40; k <= 40; ++k) reference_ = std::max(reference_, log_density_(a2_ + std::exp2(k)));
    for (const double r2 : hints.cuts)
      if (r2 > a2_) reference_ = std::max(reference_, log_density_(r2));
  }

  double scale() const { return scale_; }
  double reference() const { return reference_; }

  double operator()(double t) const {
    if (!(t < 1e150)) return 0;
    const double density = std::exp(log_density_(a2_ + t * t) - reference_);
    if (std::isnan(density))
      throw AccuracyError("lambda", "the density of slopes is not a number, at a = " + format_number(a_));
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

/// By bisection in ln t, for densities that are not analytic or have several peaks. A slow tail, p ~ t^(-2 power), is
/// integrated by hand from where t - a atan(t / a) is t to 1e-12.
Estimate bisection(const SmithIntegrand& integrand, double a, const DensityHints& hints, double absolute) {
  const auto f = [&](const double* x, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) y[k] = std::exp(x[k]) * integrand(std::exp(x[k]));
  };
  const double middle = std::log(integrand.scale());
  const bool slow = hints.power < slowest;
  const double end = slow ? std::log(1e12 * std::max(a, std::sqrt(far))) : middle + 345;
  std::vector<double> cuts;
  for (const double k : {-40, -8, -2, -1, 0, 1, 2, 8, 40})
    if (middle + k < end) cuts.push_back(middle + k);
  for (const double r2 : hints.cuts)
    if (r2 > a * a) cuts.push_back(0.5 * std::log(r2 - a * a));
  cuts.push_back(end);
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  Estimate integral = integrate(f, cuts, {.absolute = absolute, .relative = 5e-11});
  if (slow) integral.value += std::exp(end) * integrand(std::exp(end)) / (2 * hints.power - 3);
  return integral;
}

} // namespace

double a_lambda_by_quadrature(const LogDensity& log_density, double a, const DensityHints& hints) {
  throw_if_interrupted();
  if (a > 1e75) return 0;
  const SmithIntegrand integrand(log_density, a, hints);
  // Below e^-2000 the result is 0 whatever the integral is, and the rounding of the logarithm leaves no digits of that.
  if (integrand.reference() < -2000) return 0;
  const double factor = 2 * std::exp(integrand.reference());
  const bool plain = (hints.cuts.empty() || hints.cuts.back() <= a * a) && !(hints.power < slowest);
  Estimate integral;
  if (plain) integral = double_exponential(integrand);
  if (integral.value == 0 || !(integral.error <= 1e-10 * integral.value))
    integral = bisection(integrand, a, hints, negligible / factor);
  // Written so that a NaN does not pass.
  if (!(integral.error <= 1e-10 * integral.value || integral.error * factor <= negligible))
    throw AccuracyError("lambda", "Smith's integral reached a relative error of " +
                                      format_number(integral.error / integral.value) +
                                      " only (asked: 1e-10) at a = " + format_number(a));
  return factor * integral.value;
}

} // namespace brdfplot
