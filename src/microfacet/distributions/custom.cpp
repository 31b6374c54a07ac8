#include "microfacet/distributions/custom.hpp"

#include "math/errors.hpp"
#include "math/number.hpp"
#include "math/quadrature.hpp"
#include "microfacet/remembered.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace brdfplot {

namespace {

const std::vector<std::string>& variables() {
  static const std::vector<std::string> names = {"t2", "t"};
  return names;
}

/// Why a shape is none.
struct ShapeProblem {
  std::string what;
};

/// f(t2). Beyond 1e60 a formula may be infinity times 0, of which nothing is left to see.
double checked(const Formula& formula, double t2) {
  const std::array<double, 2> values = {t2, std::sqrt(t2)};
  const double f = formula(values);
  if (f >= 0 && f < infinity) return f;
  if (std::isnan(f) && t2 > 1e60) return 0;
  const std::string which = std::isnan(f) ? "not a number" : f < 0 ? "negative (" + format_number(f) + ")" : "infinite";
  throw ShapeProblem{"the shape is " + which + " at t2 = " + format_number(t2)};
}

/// Looks for what the integrals may step over.
void scan(const Formula& formula) {
  (void)checked(formula, 0);
  for (int k = -3000; k <= 3000; ++k) (void)checked(formula, std::pow(10.0, k * 0.01));
  for (int k = 1; k <= 4000; ++k) (void)checked(formula, k * 0.01);
}

/// By which power f falls at last: f ~ t2^-power. Infinite where nothing is left.
double falling_power(const Formula& formula) {
  const double near = checked(formula, 1e28);
  const double far = checked(formula, 1e30);
  return far > 0 ? std::log(near / far) / std::log(100.0) : infinity;
}

/// int_0^inf f dt2, in x = ln t2.
double mass(const Formula& formula) {
  std::vector<double> cuts;
  for (int k = -80; k <= 80; ++k) cuts.push_back(k);
  for (const int k : {120, 200, 345}) cuts.push_back(k);
  const auto integrand = [&](const double* x, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double t2 = std::exp(x[k]);
      y[k] = t2 * checked(formula, t2);
    }
  };
  const Estimate whole = integrate(integrand, cuts, {.relative = 1e-13});
  if (whole.value == 0) throw ShapeProblem{"the shape is 0 wherever it was looked at"};
  if (!(whole.error <= 1e-10 * whole.value))
    throw ShapeProblem{"the integral of the shape is uncertain by " + format_number(whole.error / whole.value) +
                       " of itself (accepted: 1e-10)"};
  return whole.value;
}

void require_finite_moments(const Formula& formula) {
  const double power = falling_power(formula);
  const std::string falls =
      "the shape falls like t2^" + format_number(0.0 - std::round(power * 1e4) / 1e4) + " to infinity";
  if (power <= 1 + 1e-6) throw ShapeProblem{falls + ": its mass is infinite; accepted: faster than t2^-1.5"};
  if (power <= 1.5 + 1e-6) throw ShapeProblem{falls + ": its mean slope is infinite; accepted: faster than t2^-1.5"};
}

CustomShape make(const Formula& formula) {
  scan(formula);
  require_finite_moments(formula);
  const double scale = std::numbers::inv_pi / mass(formula);
  try {
    const double log_scale = std::log(scale);
    return {formula, scale, ALambdaTable([=](double t2) { return std::log(checked(formula, t2)) + log_scale; })};
  } catch (const AccuracyError& error) {
    throw ShapeProblem{std::string("the masking of the shape cannot be computed: ") + error.what()};
  }
}

} // namespace

ModelSpec CustomShape::about() {
  return {.type = "custom",
          .doc = "a shape of your own: a formula of t2, the squared slope over alpha^2, and of its root t",
          .source = "Heitz 2014, Eq. 87; normalised and Lambda by quadrature",
          .parameters = {{.key = "shape",
                          .kind = ParameterKind::formula,
                          .doc = "density of slopes up to a factor, such as exp(-t2)",
                          .choices = variables()}}};
}

Made<CustomShape> CustomShape::from(const Values& values) {
  const std::string text = values.text("shape");
  try {
    return remembered<CustomShape>(text, [&] { return make(Formula(text, variables())); });
  } catch (const ShapeProblem& problem) {
    return ParameterError{"shape", problem.what};
  }
}

double CustomShape::density(double t2) const {
  try {
    return scale * checked(formula, std::min(t2, 1e300));
  } catch (const ShapeProblem& problem) {
    throw InputError("distribution", problem.what);
  }
}

double CustomShape::scaled_density(double n2, double z2) const {
  const double z2_above = std::max(z2, 1e-300);
  const double numerator = density(n2 / z2_above);
  return numerator > 0 ? numerator / z2_above / z2_above : 0;
}

} // namespace brdfplot
