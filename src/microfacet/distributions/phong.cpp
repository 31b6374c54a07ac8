#include "microfacet/distributions/phong.hpp"

#include <numbers>

namespace brdfplot {

ModelSpec Phong::spec() {
  return {.type = "phong",
          .doc = "power of the cosine; masking by quadrature of its own slopes",
          .source = "Walter et al. 2007, Eqs. 30-33; Heitz 2014, section 7",
          .parameters = {{.key = "exponent", .bounds = {.min = -1, .open_min = true}, .doc = "n of cos^n theta_m"},
                         {.key = "alpha",
                          .bounds = {.min = 0, .max = std::numbers::sqrt2, .open_min = true, .open_max = true},
                          .doc = "roughness of the like Beckmann surface; n = 2 / alpha^2 - 2"}},
          .alternatives = {{"exponent"}, {"alpha"}}};
}

Phong Phong::from(const Values& values) {
  Phong phong;
  if (values.has("exponent")) {
    phong.exponent = values.number("exponent");
    phong.slopes.alpha_x = std::sqrt(2 / (phong.exponent + 2));
  } else {
    phong.slopes.alpha_x = values.number("alpha");
    phong.exponent = 2 / (phong.slopes.alpha_x * phong.slopes.alpha_x) - 2;
  }
  phong.slopes.alpha_y = phong.slopes.alpha_x;
  return phong;
}

namespace {

/// ln of (n + 2) / (2 pi) (1 + r2)^(-power).
double log_lobe(double exponent, double power, double r2) {
  return std::log((exponent + 2) * 0.5 * std::numbers::inv_pi) - power * std::log1p(r2);
}

double lobe(double exponent, double power, double r2) {
  return (exponent + 2) * 0.5 * std::numbers::inv_pi * std::exp(-power * std::log1p(r2));
}

} // namespace

double Phong::p22(double slope_x, double slope_y) const {
  return lobe(exponent, 0.5 * (exponent + 4), slope_x * slope_x + slope_y * slope_y);
}

double Phong::density(const Direction& omega_m) const {
  if (!(omega_m.z > 0)) return 0;
  const double tan2 = (omega_m.x * omega_m.x + omega_m.y * omega_m.y) / (omega_m.z * omega_m.z);
  return lobe(exponent, 0.5 * exponent, tan2);
}

double Phong::masked_area(const Projection& p) const {
  if (!(p.s > 0) || !(p.c > 0)) return 0;
  const double sin_theta = p.s / slopes.alpha_x;
  const double power = 0.5 * (exponent + 4);
  return sin_theta * a_lambda_by_quadrature([&](double r2) { return log_lobe(exponent, power, r2); }, p.c / sin_theta);
}

} // namespace brdfplot
