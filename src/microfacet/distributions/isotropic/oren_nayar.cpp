#include "microfacet/distributions/isotropic/oren_nayar.hpp"

#include "base/number.hpp"
#include "math/quadrature.hpp"
#include "microfacet/remembered.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace brdfplot {

namespace {

/// int_0^(pi/2) exp(-(theta / sigma)^2 / 2) sin(theta) dtheta, to rounding.
double angle_integral(double sigma) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  const std::array<double, 3> cuts = {0, std::min(3 * sigma, quarter), std::min(10 * sigma, quarter)}; // e^-50
  const auto integrand = [&](const double* theta, double* y, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double t = theta[k] / sigma;
      y[k] = std::exp(-0.5 * t * t) * std::sin(theta[k]);
    }
  };
  return integrate(integrand, cuts, {.relative = 2e-14}).value;
}

double fall(double sigma, double angle) {
  const double t = angle / sigma;
  return std::exp(-0.5 * t * t);
}

} // namespace

ModelSpec OrenNayarProfile::spec() {
  return {.type = "oren_nayar",
          .doc =
              "D cos(theta_m) falls like exp(-theta_m^2 / (2 sigma^2)); has no Smith masking, its Lambda is infinite",
          .source = "Oren and Nayar 1994, section 3: the slope-area distribution",
          .parameters = {
              {.key = "sigma", .bounds = {.min = 1e-6, .max = 1e3}, .doc = "standard deviation of the angle, rad"}}};
}

OrenNayarProfile OrenNayarProfile::from(const Values& values) {
  const double sigma = values.number("sigma");
  return remembered<OrenNayarProfile>(format_number(sigma), [=] {
    return OrenNayarProfile{sigma, 0.5 * std::numbers::inv_pi / angle_integral(sigma)};
  });
}

double OrenNayarProfile::width() const { return std::tan(std::fmin(std::numbers::sqrt2 * sigma, 1)); }

double OrenNayarProfile::p22(double r2) const {
  const double z = 1 / std::sqrt(1 + r2);
  return peak * fall(sigma, std::atan(std::sqrt(r2))) * z * z * z;
}

double OrenNayarProfile::density(double sin2, double z) const {
  return peak * fall(sigma, std::atan2(std::sqrt(sin2), z)) / std::fmax(z, 1e-300);
}

double OrenNayarProfile::a_lambda(double a) const { return a < infinity ? infinity : 0; }

} // namespace brdfplot
