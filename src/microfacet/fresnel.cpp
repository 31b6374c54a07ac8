#include "microfacet/fresnel.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot {

namespace {

const Bounds indices{.min = 1e-6, .max = 1e6};
const Bounds absorptions{.min = 0, .max = 1e6};
const Bounds exponents{.min = 1e-3, .max = 1e3};
const Bounds unit_interval{.min = 0, .max = 1};

double square(double x) { return x * x; }

} // namespace

double schlick_reflectance(double c, double f0, double f90, double exponent) {
  const double grazing = exponent == 5 ? square(square(1 - c)) * (1 - c) : std::pow(1 - c, exponent);
  return f0 * (1 - grazing) + f90 * grazing;
}

double dielectric_reflectance(double c, double eta) {
  // eta^2 - sin^2 as a sum of two terms of one sign for eta > 1.
  const double radicand = (eta - 1) * (eta + 1) + c * c;
  if (radicand <= 0) return 1;
  const double g = std::sqrt(radicand); // eta cos theta_t
  const double perpendicular = (c - g) / (c + g);
  const double parallel = (eta * eta * c - g) / (eta * eta * c + g);
  return 0.5 * (square(perpendicular) + square(parallel));
}

double conductor_reflectance(double c, double eta, double k) {
  const double s2 = (1 - c) * (1 + c);
  const double t = (eta - k) * (eta + k) - s2;
  const double w = std::hypot(t, 2 * eta * k);
  // p = q + i y is the root of t + 2 i eta k with q >= 0; the larger part first, the other by division.
  const double large = std::sqrt(0.5 * (w + std::fabs(t)));
  const double small = large > 0 ? eta * k / large : 0;
  const double q = t >= 0 ? large : small;
  const double y = t >= 0 ? small : large;
  const double perpendicular_denominator = square(c + q) + square(y);
  if (perpendicular_denominator == 0) return 0; // eta = 1, k = 0: no interface
  const double perpendicular = (square(c - q) + square(y)) / perpendicular_denominator;
  const double parallel_denominator = square(c * q + s2) + square(c * y);
  const double parallel = parallel_denominator > 0 ? (square(c * q - s2) + square(c * y)) / parallel_denominator : 1;
  return 0.5 * perpendicular * (1 + parallel);
}

ModelSpec SchlickFresnel::spec() {
  return {.type = "schlick",
          .doc = "f0 + (f90 - f0) (1 - cos)^exponent",
          .source = "Schlick 1994; Akenine-Moller et al. 2018, Eq. 9.18",
          .parameters = {{.key = "f0",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = unit_interval,
                          .doc = "reflectance at normal incidence"},
                         {.key = "f90",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = unit_interval,
                          .fallback = 1.0,
                          .doc = "reflectance at grazing"},
                         {.key = "exponent", .bounds = exponents, .fallback = 5.0, .doc = "how late it rises"}}};
}

SchlickFresnel SchlickFresnel::from(const Values& values) {
  return {values.rgb("f0"), values.rgb("f90"), values.number("exponent"), values.is_rgb("f0") || values.is_rgb("f90")};
}

Rgb SchlickFresnel::reflectance(double c) const {
  c = std::min(c, 1.0);
  Rgb out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = schlick_reflectance(c, f0[i], f90[i], exponent);
  return out;
}

ModelSpec DielectricFresnel::spec() {
  return {.type = "dielectric",
          .doc = "smooth dielectric, unpolarised",
          .source = "Fresnel; Walter et al. 2007, Eq. 22",
          .parameters = {{.key = "eta",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = indices,
                          .doc = "relative index of refraction"}}};
}

DielectricFresnel DielectricFresnel::from(const Values& values) { return {values.rgb("eta"), values.is_rgb("eta")}; }

Rgb DielectricFresnel::reflectance(double c) const {
  c = std::min(c, 1.0);
  return {dielectric_reflectance(c, eta[0]), dielectric_reflectance(c, eta[1]), dielectric_reflectance(c, eta[2])};
}

std::optional<double> DielectricFresnel::critical_cosine(std::size_t channel) const {
  const double c2 = (1 - eta[channel]) * (1 + eta[channel]);
  return c2 > 0 ? std::optional(std::sqrt(c2)) : std::nullopt;
}

ModelSpec ConductorFresnel::spec() {
  return {.type = "conductor",
          .doc = "smooth conductor, unpolarised",
          .source = "Fresnel; Born and Wolf 1999, section 14.2",
          .parameters = {{.key = "eta",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = indices,
                          .doc = "real part of the relative index"},
                         {.key = "k",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = absorptions,
                          .doc = "imaginary part of the relative index"}}};
}

ConductorFresnel ConductorFresnel::from(const Values& values) {
  return {values.rgb("eta"), values.rgb("k"), values.is_rgb("eta") || values.is_rgb("k")};
}

std::optional<double> ConductorFresnel::critical_cosine(std::size_t channel) const {
  const double c2 = 1 - (eta[channel] - k[channel]) * (eta[channel] + k[channel]);
  return c2 > 0 && c2 < 1 ? std::optional(std::sqrt(c2)) : std::nullopt;
}

Rgb ConductorFresnel::reflectance(double c) const {
  c = std::min(c, 1.0);
  Rgb out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = conductor_reflectance(c, eta[i], k[i]);
  return out;
}

} // namespace brdfplot
