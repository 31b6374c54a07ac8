#include "microfacet/distributions/phong.hpp"

#include <numbers>

namespace brdfplot {

ModelSpec PhongProfile::spec() {
  ModelSpec spec{.type = "phong",
                 .doc = "power of the cosine; masking by quadrature of its own slopes",
                 .source = "Walter et al. 2007, Eqs. 30-33; Heitz 2014, section 7",
                 .parameters =
                     isotropic_roughness({.min = 0, .max = std::numbers::sqrt2, .open_min = true, .open_max = true},
                                         "roughness of the like Beckmann surface; n = 2 / alpha^2 - 2"),
                 .alternatives = {{"exponent"}, {"alpha"}, {"roughness"}}};
  spec.parameters.insert(spec.parameters.begin(),
                         {.key = "exponent", .bounds = {.min = -1, .open_min = true}, .doc = "n of cos^n theta_m"});
  return spec;
}

namespace {

/// ln of (n + 2) / (2 pi) (1 + r2)^(-power).
double log_lobe(double exponent, double power, double r2) {
  return std::log((exponent + 2) * 0.5 * std::numbers::inv_pi) - power * std::log1p(r2);
}

double lobe(double exponent, double power, double r2) {
  return (exponent + 2) * 0.5 * std::numbers::inv_pi * std::exp(-power * std::log1p(r2));
}

PhongProfile make(double exponent, double alpha) {
  const double alpha2 = alpha * alpha;
  return {exponent, alpha, ALambdaTable([=](double t2) {
            return log_lobe(exponent, 0.5 * (exponent + 4), alpha2 * t2) + std::log(alpha2);
          })};
}

} // namespace

PhongProfile PhongProfile::from(const Values& values) {
  if (values.has("exponent")) {
    const double exponent = values.number("exponent");
    return make(exponent, std::sqrt(2 / (exponent + 2)));
  }
  const double alpha = alpha_from(values);
  return make(2 / (alpha * alpha) - 2, alpha);
}

double PhongProfile::p22(double r2) const { return lobe(exponent, 0.5 * (exponent + 4), r2); }

double PhongProfile::density(double sin2, double z) const { return lobe(exponent, 0.5 * exponent, sin2 / (z * z)); }

} // namespace brdfplot
