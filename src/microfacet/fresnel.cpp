#include "microfacet/fresnel.hpp"

#include "math/kernels/kernels.hpp"

#include <cmath>

namespace brdfplot {

namespace {

const Bounds indices{.min = 1e-6, .max = 1e6};
const Bounds absorptions{.min = 0, .max = 1e6};
const Bounds exponents{.min = 1e-3, .max = 1e3};
const Bounds unit_interval{.min = 0, .max = 1};

} // namespace

double schlick_reflectance(double c, double f0, double f90, double exponent) {
  double f = 0;
  kernels::reflectance_schlick(&c, f0, f90, exponent, &f, 1);
  return f;
}

double dielectric_reflectance(double c, double eta) {
  double f = 0;
  kernels::reflectance_dielectric(&c, eta, &f, 1);
  return f;
}

double conductor_reflectance(double c, double eta, double k) {
  double f = 0;
  kernels::reflectance_conductor(&c, eta, k, &f, 1);
  return f;
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

void SchlickFresnel::reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const {
  kernels::reflectance_schlick(c, f0[channel], f90[channel], exponent, f, n);
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

void DielectricFresnel::reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const {
  kernels::reflectance_dielectric(c, eta[channel], f, n);
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

void ConductorFresnel::reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const {
  kernels::reflectance_conductor(c, eta[channel], k[channel], f, n);
}

} // namespace brdfplot
