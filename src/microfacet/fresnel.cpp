#include "microfacet/fresnel.hpp"

#include "base/errors.hpp"
#include "base/number.hpp"
#include "math/kernels/kernels.hpp"
#include "math/quadrature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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
  return {
      .type = "schlick",
      .doc = "f0 + (f90 - f0) (1 - cos)^exponent",
      .source = "Schlick 1994, Eq. 24; Akenine-Moller et al. 2018, Eq. 9.18",
      .parameters = {
          {.key = "f0",
           .kind = ParameterKind::number_or_rgb,
           .bounds = unit_interval,
           .doc = "reflectance at normal incidence"},
          {.key = "f90",
           .kind = ParameterKind::number_or_rgb,
           .bounds = unit_interval,
           .fallback = 1.0,
           .doc = "reflectance at grazing"},
          {.key = "exponent", .bounds = exponents, .fallback = 5.0, .doc = "how late it rises; 1 / p of Eq. 9.18"}}};
}

SchlickFresnel SchlickFresnel::from(const Values& values) {
  return {values.rgb("f0"), values.rgb("f90"), values.number("exponent"), values.is_rgb("f0") || values.is_rgb("f90")};
}

void SchlickFresnel::reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const {
  kernels::reflectance_schlick(c, f0[channel], f90[channel], exponent, f, n);
}

/// (1 - f0) (1 - q) + (1 - f90) q, q = (1 - c)^exponent.
void SchlickFresnel::losses(const double* c, std::size_t channel, double* left, std::size_t n) const {
  for (std::size_t k = 0; k < n; ++k) {
    const double log_q = exponent * std::log1p(-c[k]);
    left[k] = (1 - f0[channel]) * -std::expm1(log_q) + (1 - f90[channel]) * std::exp(log_q);
  }
}

namespace {

/// c (1 - c)^6 at c = 1/7, its maximum, and (1 - c)^5 there.
constexpr double dip_at_82 = 46656.0 / 823543, fifth_at_82 = 7776.0 / 16807;

double schlick_at_82(double f0) { return f0 + (1 - f0) * fifth_at_82; }

} // namespace

double SchlickFresnel::mean(std::size_t channel) const {
  const double n = exponent;
  return (f0[channel] * (n * (n + 3)) + f90[channel] * 2) / ((n + 1) * (n + 2));
}

ModelSpec F82Fresnel::spec() {
  return {.type = "f82",
          .doc = "Schlick's, times f82 at 82 degrees, as the dip of metals: B - a cos (1 - cos)^6",
          .source = "Lazanyi and Szirmay-Kalos 2005; Hoffman 2019; Kutz, Hasan and Edmondson 2021",
          .parameters = {{.key = "f0",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = unit_interval,
                          .doc = "reflectance at normal incidence"},
                         {.key = "f82",
                          .kind = ParameterKind::number_or_rgb,
                          .bounds = unit_interval,
                          .doc = "factor of Schlick's reflectance where cos = 1/7"}}};
}

double F82Fresnel::coefficient(double f0, double f82) { return schlick_at_82(f0) * (1 - f82) / dip_at_82; }

/// F = F' = 0 at u = 1 - c, where u^5 (2u - 1) = r (6 - 7u), r = f0 / (1 - f0), and a = 5 (1 - f0) / (u (6 - 7u)): of
/// the two sides the left one rises and the right one falls.
double F82Fresnel::least_f82(double f0) {
  if (f0 == 1) return 0;
  const double r = f0 / (1 - f0);
  double low = 0.5, high = 6.0 / 7;
  for (int k = 0; k < 60; ++k) {
    const double u = 0.5 * (low + high), u2 = u * u;
    (u2 * u2 * u * (2 * u - 1) < r * (6 - 7 * u) ? low : high) = u;
  }
  // r (6 - 7u) instead of 6 - 7u, which cancels where r is large.
  const double u2 = low * low, rest = r > 1 ? u2 * u2 * low * (2 * low - 1) / r : 6 - 7 * low;
  const double a = 5 * (1 - f0) / (low * rest);
  return std::max(0.0, 1 - a * dip_at_82 / schlick_at_82(f0));
}

Made<F82Fresnel> F82Fresnel::from(const Values& values) {
  F82Fresnel made{values.rgb("f0"), values.rgb("f82"), values.is_rgb("f0") || values.is_rgb("f82")};
  for (std::size_t k = 0; k < 3; ++k) {
    const double least = least_f82(made.f0[k]);
    if (made.f82[k] < least)
      return ParameterError{"f82", "found " + format_number(made.f82[k]) + " with f0 = " + format_number(made.f0[k]) +
                                       ", where the reflectance falls below 0; accepted: a number in [" +
                                       format_number(least) + ", 1]"};
  }
  return made;
}

/// F = f0 (1 - u^5) + u^5 (1 - a c u), u = 1 - c.
void F82Fresnel::reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const {
  const double normal = f0[channel], a = coefficient(normal, f82[channel]);
  for (std::size_t k = 0; k < n; ++k) {
    const double u = 1 - c[k], u2 = u * u;
    const double complement = c[k] * (1 + u * (1 + u * (1 + u * (1 + u))));
    f[k] = std::max(0.0, normal * complement + u2 * u2 * u * (1 - a * c[k] * u));
  }
}

/// (1 - f0) (1 - u^5) + a c u^6.
void F82Fresnel::losses(const double* c, std::size_t channel, double* left, std::size_t n) const {
  const double normal = f0[channel], a = coefficient(normal, f82[channel]);
  for (std::size_t k = 0; k < n; ++k) {
    const double u = 1 - c[k], u2 = u * u;
    const double complement = c[k] * (1 + u * (1 + u * (1 + u * (1 + u))));
    left[k] = std::min(1.0, (1 - normal) * complement + a * c[k] * u2 * u2 * u2);
  }
}

double F82Fresnel::mean(std::size_t channel) const {
  return f0[channel] + (1 - f0[channel]) / 21 - coefficient(f0[channel], f82[channel]) / 126;
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

namespace {

/// eta^2 - (1 - c^2), where eta and 1 are close at grazing, and 1 and c are at the normal, by their differences.
double refracted_cosine2(double eta, double c) {
  if (c * c < 0.5) return (eta - 1) * (eta + 1) + c * c;
  const double s = std::sqrt((1 - c) * (1 + c));
  return (eta - s) * (eta + s);
}

} // namespace

/// 2 c g (1 / (c + g)^2 + eta^2 / (eta^2 c + g)^2), g^2 = eta^2 - 1 + c^2: what both polarisations refract. 0 where g^2
/// is negative.
void DielectricFresnel::losses(const double* c, std::size_t channel, double* left, std::size_t n) const {
  const double index = eta[channel], index2 = index * index;
  for (std::size_t k = 0; k < n; ++k) {
    const double g = std::sqrt(std::max(0.0, refracted_cosine2(index, c[k])));
    const double s = c[k] + g, p = index2 * c[k] + g;
    left[k] = g > 0 ? 2 * c[k] * g * (1 / (s * s) + index2 / (p * p)) : 0;
  }
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

/// With g = a + i b, g^2 = (eta + i k)^2 - s^2, s^2 = 1 - c^2: of the one polarisation R = 1 - 4 a c / ((a + c)^2 +
/// b^2), of the other R times 1 - 4 a c s^2 / ((a c + s^2)^2 + b^2 c^2). a and b, whose product is eta k, without a
/// difference.
void ConductorFresnel::losses(const double* c, std::size_t channel, double* left, std::size_t n) const {
  const double index = eta[channel], absorbed = k[channel];
  for (std::size_t at = 0; at < n; ++at) {
    const double cosine = c[at], s2 = (1 - cosine) * (1 + cosine), product = index * absorbed;
    const double real = refracted_cosine2(index, cosine) - absorbed * absorbed;
    const double larger = std::sqrt(0.5 * (std::hypot(real, 2 * product) + std::fabs(real)));
    const double smaller = larger > 0 ? product / larger : 0;
    const double a = real > 0 ? larger : smaller, b = real > 0 ? smaller : larger;
    const double first = 4 * a * cosine / ((a + cosine) * (a + cosine) + b * b);
    const double along = a * cosine + s2;
    const double second = 4 * a * cosine * s2 / (along * along + b * b * cosine * cosine);
    left[at] = a > 0 && cosine > 0 ? 0.5 * (first + (first + (1 - first) * second)) : 0;
  }
}

namespace {

/// The integral up to where F is not smooth, by c = critical (1 - t^2), or from there on, by c = critical + (1 -
/// critical) t^2: in t what is a root in c is smooth.
template <class F>
Estimate mean_of_part(const F& fresnel, std::size_t channel, double critical, bool above) {
  const double range = above ? 1 - critical : critical;
  const auto integrand = [&](const double* t, double* y, std::size_t n) {
    std::vector<double> c(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double way = range * t[k] * t[k];
      c[k] = std::clamp(above ? critical + way : critical - way, 0.0, 1.0);
    }
    fresnel.reflectances(c.data(), channel, y, n);
    for (std::size_t k = 0; k < n; ++k) y[k] *= 4 * range * t[k] * c[k];
  };
  const std::array<double, 2> ends = {0, 1};
  return integrate(integrand, ends, {.absolute = 0, .relative = 1e-13});
}

template <class F>
double mean_by_quadrature(const F& fresnel, std::size_t channel) {
  const double critical = fresnel.critical_cosine(channel).value_or(0);
  const Estimate above = mean_of_part(fresnel, channel, critical, true);
  const Estimate below = critical > 0 ? mean_of_part(fresnel, channel, critical, false) : Estimate{};
  const double mean = above.value + below.value, error = above.error + below.error;
  if (!(error <= 1e-12 * mean) && mean > 0)
    throw AccuracyError("fresnel", "the mean reflectance " + format_number(mean) + " has an error of " +
                                       format_number(error) + " by estimate, wanted: 1e-12 of it");
  return mean;
}

} // namespace

double mean_fresnel(const Fresnel& fresnel, std::size_t channel) {
  return std::visit(
      [channel](const auto& of) {
        if constexpr (requires { of.mean(channel); })
          return of.mean(channel);
        else
          return mean_by_quadrature(of, channel);
      },
      fresnel);
}

} // namespace brdfplot
