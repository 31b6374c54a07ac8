#include "microfacet/distributions/gtr.hpp"

#include <numbers>

namespace brdfplot {

namespace {

/// ln((e^x - 1) / x), whole real line.
double log_phi(double x) {
  if (x == 0) return 0;
  if (std::fabs(x) < 1e-5) return x / 2 + x * x / 24; // next term x^4 / 2880
  if (x > 30) return x - std::log(x);                 // e^-x is below half an ulp
  return std::log(std::expm1(x) / x);
}

} // namespace

double gtr_log_normalization(double alpha, double gamma) {
  const double log_alpha2 = 2 * std::log(alpha);
  return log_phi(log_alpha2) - log_phi((1 - gamma) * log_alpha2);
}

ModelSpec Gtr::spec() {
  const Bounds positive{.min = 0, .open_min = true};
  return {.type = "gtr",
          .doc = "generalized Trowbridge-Reitz; masking by quadrature of its own slopes",
          .source = "Burley 2012; Akenine-Moller et al. 2018, Eqs. 9.46-9.47",
          .parameters = {{.key = "alpha", .bounds = positive, .doc = "roughness"},
                         {.key = "gamma", .bounds = positive, .doc = "exponent of the tail; 2 is GGX"}}};
}

Gtr Gtr::from(const Values& values) {
  Gtr gtr;
  gtr.gamma = values.number("gamma");
  gtr.slopes.alpha_x = gtr.slopes.alpha_y = values.number("alpha");
  gtr.log_k = gtr_log_normalization(gtr.slopes.alpha_x, gtr.gamma);
  return gtr;
}

double Gtr::log_p22(double r2) const {
  const double alpha2 = slopes.alpha_x * slopes.alpha_x;
  return log_k - std::log(std::numbers::pi) + (gamma - 2) * std::log1p(r2) - gamma * std::log(r2 + alpha2);
}

double Gtr::p22(double slope_x, double slope_y) const {
  return std::exp(log_p22(slope_x * slope_x + slope_y * slope_y));
}

double Gtr::density(const Direction& omega_m) const {
  if (!(omega_m.z > 0)) return 0;
  const double alpha_z = slopes.alpha_x * omega_m.z;
  const double base = omega_m.x * omega_m.x + omega_m.y * omega_m.y + alpha_z * alpha_z;
  return std::numbers::inv_pi * std::exp(log_k - gamma * std::log(base));
}

double Gtr::masked_area(const Projection& p) const {
  if (!(p.s > 0) || !(p.c > 0)) return 0;
  const double sin_theta = p.s / slopes.alpha_x;
  return sin_theta * a_lambda_by_quadrature([this](double r2) { return log_p22(r2); }, p.c / sin_theta);
}

} // namespace brdfplot
