#include "microfacet/distributions/isotropic/ward.hpp"

#include "base/number.hpp"
#include "microfacet/beckmann_lambda.hpp"
#include "microfacet/remembered.hpp"

#include <numbers>

namespace brdfplot {

namespace {

/// erfcx(x) = e^(x^2) erfc x, x > 0; beyond 2 from 1 - sqrt(pi) x erfcx(x) (see beckmann_lambda.hpp).
double scaled_erfc(double x) {
  if (x < 2) return std::exp(x * x) * std::erfc(x);
  return std::numbers::inv_sqrtpi * (1 - 1 / detail::beckmann_terms(x).denominator) / x;
}

} // namespace

ModelSpec WardProfile::spec() {
  return {.type = "ward",
          .doc = "exp(-tan^2 / alpha^2) / cos^3; printed with int D = 1, here int D cos = 1 as of every distribution",
          .source = "Ward 1992; Kelemen and Szirmay-Kalos 2001, Eq. 4",
          .parameters = isotropic_roughness({.min = 1e-6, .max = 1e3}, "roughness, m of the paper"),
          .alternatives = {{"alpha"}, {"roughness"}}};
}

namespace {

double log_ward_slope_density(double log_peak, double alpha, double r2) {
  return log_peak - r2 / (alpha * alpha) - 0.5 * std::log1p(r2);
}

} // namespace

WardProfile WardProfile::from(const Values& values) {
  const double alpha = alpha_from(values);
  const double log_peak = -std::log(std::numbers::pi / std::numbers::inv_sqrtpi * alpha * scaled_erfc(1 / alpha));
  const double alpha2 = alpha * alpha;
  return remembered<WardProfile>(format_number(alpha), [=] {
    return WardProfile{alpha, log_peak, ALambdaTable([=](double t2) {
                         return log_ward_slope_density(log_peak, alpha, alpha2 * t2) + std::log(alpha2);
                       })};
  });
}

double WardProfile::p22(double r2) const { return std::exp(log_ward_slope_density(log_peak, alpha, r2)); }

double WardProfile::density(double sin2, double z) const {
  const double numerator = std::exp(log_peak - sin2 / (z * z) / (alpha * alpha));
  return numerator > 0 ? numerator / (z * z * z) : 0;
}

} // namespace brdfplot
