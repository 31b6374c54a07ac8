#include "microfacet/distributions/isotropic/gaussian.hpp"

#include "base/number.hpp"
#include "math/quadrature.hpp"
#include "microfacet/remembered.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace brdfplot {

namespace {

/// int_0^(pi/2) exp(-(theta / alpha)^2) sin(2 theta) dtheta, to rounding.
double integral(double alpha) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  const std::array<double, 3> cuts = {0, std::min(2 * alpha, quarter), std::min(7 * alpha, quarter)}; // e^-49
  const auto integrand = [&](const double* theta, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double t = theta[k] / alpha;
      y[k] = std::exp(-t * t) * std::sin(2 * theta[k]);
    }
  };
  return integrate(integrand, cuts, {.relative = 2e-14}).value;
}

} // namespace

ModelSpec GaussianProfile::spec() {
  return {.type = "gaussian",
          .doc = "exp(-(theta_m / alpha)^2); printed with a free factor, here int D cos = 1",
          .source = "Torrance and Sparrow 1967; Blinn 1977; Cook and Torrance 1982",
          .parameters = isotropic_roughness({.min = 1e-6, .max = 1e3}, "width of the angle, rad"),
          .alternatives = {{"alpha"}, {"roughness"}}};
}

namespace {

double log_slope_density(double log_peak, double alpha, double r2) {
  const double angle = std::atan(std::sqrt(r2)) / alpha;
  return log_peak - angle * angle - 2 * std::log1p(r2);
}

} // namespace

GaussianProfile GaussianProfile::from(const Values& values) {
  const double alpha = alpha_from(values);
  const double width2 = width(alpha) * width(alpha);
  return remembered<GaussianProfile>(format_number(alpha), [=] {
    const double log_of_peak = -std::log(std::numbers::pi * integral(alpha));
    return GaussianProfile{alpha, log_of_peak, ALambdaTable([=](double t2) {
                             return log_slope_density(log_of_peak, alpha, width2 * t2) + std::log(width2);
                           })};
  });
}

double GaussianProfile::p22(double r2) const { return std::exp(log_slope_density(log_peak, alpha, r2)); }

double GaussianProfile::density(double sin2, double z) const {
  const double angle = std::atan2(std::sqrt(sin2), z) / alpha;
  return std::exp(log_peak - angle * angle);
}

} // namespace brdfplot
