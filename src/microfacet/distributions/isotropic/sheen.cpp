#include "microfacet/distributions/isotropic/sheen.hpp"

#include "base/number.hpp"
#include "microfacet/remembered.hpp"

#include <boost/math/quadrature/exp_sinh.hpp>

#include <numbers>

namespace brdfplot {

namespace {

/// (F - c) / x = sum_(n >= 1) (-1/2)_n / n! ((-m)_n / n! - 1) x^(n - 1), (m + 1) x <= 1/2.
double excess_by_series(double m, double x) {
  double binomial = -0.5; // (-1/2)_n / n! x^(n - 1)
  double other = -m;      // (-m)_n / n!
  double sum = binomial * (other - 1);
  // A term may be 0 and those after it not: m = 2 has one. Its two parts together halve at least from each to the next.
  for (int n = 2; std::fabs(binomial) * (std::fabs(other) + 1) > 1e-18 * sum; ++n) {
    binomial *= x * (n - 1.5) / n;
    other *= (n - 1 - m) / n;
    sum += binomial * (other - 1);
  }
  return sum;
}

/// F by its integral over u = tan f, which is analytic in ln u on |Im ln u| < pi / 2 whatever m and c are.
double transform(double m, double c, double x) {
  thread_local boost::math::quadrature::exp_sinh<double> rule;
  const double scale = 1 / std::sqrt(1 + m * x);
  const double c2 = c * c;
  const auto integrand = [&](double v) {
    const double u = scale * v;
    if (!(u < 1e150)) return 0.0;
    const double u2 = u * u;
    const double power = std::exp(-m * std::log1p(x * u2 / (1 + c2 * u2)));
    return scale * power * (c2 + 2 * (m + 1) * x / (1 + u2)) / (1 + u2);
  };
  return 2 * std::numbers::inv_pi * rule.integrate(integrand, 1e-11);
}

} // namespace

ModelSpec SheenProfile::spec() {
  return {.type = "sheen",
          .doc = "power of the sine, for cloth; Lambda exact",
          .source = "Estevez and Kulla 2017; Akenine-Moller et al. 2018, Eq. 9.75",
          .parameters = isotropic_roughness({.min = 1e-6, .max = 1e6}, "roughness r; the power is 1 / r"),
          .alternatives = {{"alpha"}, {"roughness"}}};
}

SheenProfile SheenProfile::from(const Values& values) {
  const double alpha = alpha_from(values);
  return {alpha, remembered<ALambdaTable>("sheen " + format_number(alpha), [alpha] {
            return ALambdaTable::of_exact(
                [profile = SheenProfile{alpha}](double a) { return profile.exact_a_lambda(a); });
          })};
}

double SheenProfile::p22(double r2) const {
  const double m = half_power();
  const double z2 = 1 / (1 + r2);
  return std::numbers::inv_pi * (1 + m) * std::exp(-m * std::log1p(1 / r2)) * z2 * z2;
}

double SheenProfile::density(double sin2, double z) const {
  const double m = half_power();
  const double log_sin2 = z < 0.5 ? std::log1p(-z * z) : std::log(sin2);
  return std::numbers::inv_pi * (1 + m) * std::exp(m * log_sin2);
}

double SheenProfile::exact_a_lambda(double a) const {
  const double m = half_power();
  const double mu = a * width();
  const double sin_theta = 1 / std::hypot(1.0, mu);
  const double x = sin_theta * sin_theta;
  // a Lambda = c Lambda / (width sin)
  if ((m + 1) * x < 0.5) return 0.5 * excess_by_series(m, x) * (sin_theta / width());
  const double c = mu * sin_theta;
  return 0.5 * (transform(m, c, x) - c) / (width() * sin_theta);
}

} // namespace brdfplot
