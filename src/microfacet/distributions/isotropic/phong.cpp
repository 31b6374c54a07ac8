#include "microfacet/distributions/isotropic/phong.hpp"

#include "base/number.hpp"

#include <algorithm>
#include <numbers>

namespace brdfplot {

ModelSpec PhongProfile::spec() {
  ModelSpec spec{
      .type = "phong",
      .doc = "power of the cosine; its own masking exact, as of Student's t with gamma = n / 2 + 2",
      .source = "Walter et al. 2007, Eqs. 30-33; Kelemen and Szirmay-Kalos 2001, Eq. 5; Akenine-Moller et al. 2018, "
                "Eq. 9.40; Heitz 2014, section 7; Ribardiere et al. 2017",
      .parameters =
          isotropic_roughness({.min = 1e-6, .max = std::numbers::sqrt2, .open_max = true},
                              "roughness of the Beckmann surface that is about as rough; n = 2 / alpha^2 - 2"),
      .alternatives = {{"exponent"}, {"alpha"}, {"roughness"}, {"gloss"}, {"exponent", "mean_normal_length"}}};
  spec.parameters.insert(
      spec.parameters.begin(),
      {.key = "exponent", .bounds = {.min = -1, .max = 2e12, .open_min = true}, .doc = "n of cos^n theta_m"});
  spec.parameters.push_back({.key = "gloss",
                             .bounds = {.min = 0, .max = 1},
                             .doc = "s of n = 8192^s (Akenine-Moller et al. 2018, section 9.8.1: n = m^s)"});
  spec.parameters.push_back(mean_normal_length());
  return spec;
}

namespace {

double lobe(double exponent, double power, double r2) {
  return (exponent + 2) * 0.5 * std::numbers::inv_pi * std::exp(-power * std::log1p(r2));
}

} // namespace

PhongProfile PhongProfile::from(const Values& values) {
  if (values.has("exponent") || values.has("gloss")) {
    double exponent = values.has("gloss") ? std::exp2(13 * values.number("gloss")) : values.number("exponent");
    if (values.has("mean_normal_length")) exponent = toksvig_exponent(exponent, values.number("mean_normal_length"));
    return {exponent, std::sqrt(2 / (exponent + 2)), StudentTShape::of_excess(0.5 * (exponent + 1))};
  }
  const double alpha = alpha_from(values);
  const double alpha2 = alpha * alpha;
  // n + 1 = (2 - alpha^2) / alpha^2, whose difference is rounded once however near to sqrt(2) alpha is.
  return {2 / alpha2 - 2, alpha, StudentTShape::of_excess(0.5 * std::fma(-alpha, alpha, 2) / alpha2)};
}

std::optional<ParameterError> PhongProfile::problem(const Values& values) {
  if (!values.has("mean_normal_length") || values.number("exponent") >= 0) return std::nullopt;
  return ParameterError{"exponent", "found " + format_number(values.number("exponent")) +
                                        ", accepted beside \"mean_normal_length\": a number in [0, 2e+12]"};
}

double PhongProfile::p22(double r2) const { return lobe(exponent, 0.5 * (exponent + 4), r2); }

double PhongProfile::density(double sin2, double z) const {
  const double z_above = std::max(z, 1e-150);
  return lobe(exponent, 0.5 * exponent, sin2 / (z_above * z_above));
}

} // namespace brdfplot
