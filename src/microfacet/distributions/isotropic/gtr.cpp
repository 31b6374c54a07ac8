#include "microfacet/distributions/isotropic/gtr.hpp"

#include <algorithm>
#include <cmath>
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

/// ln(1 - u + u e^x), whole real line.
double log_mean_of_powers(double u, double x) {
  return x > 30 ? x + std::log(u + (1 - u) * std::exp(-x)) : std::log1p(u * std::expm1(x));
}

} // namespace

double gtr_log_normalization(double alpha, double gamma) {
  const double log_alpha2 = 2 * std::log(alpha);
  return log_phi(log_alpha2) - log_phi((1 - gamma) * log_alpha2);
}

double gtr_a_lambda_closed(double alpha, int gamma, double a) {
  if (a > 1e100) return 0; // below 1e-100 and soon an overflow
  const double h = std::hypot(1.0, a);
  const double alpha2 = alpha * alpha;
  const double inverse = 1 / (a + h); // h - a
  if (gamma == 1) {
    const double mu = alpha * a;
    const double b = std::hypot(1.0, mu);
    const double sum = alpha * h + b;
    const double log_alpha2 = 2 * std::log(alpha);
    const double d = std::expm1(log_alpha2) / (sum * (mu + b));
    const double quotient = d == 0 ? 1 : std::log1p(d) / d;
    return std::exp(log_phi(log_alpha2)) * (1 - mu / (mu + b) * quotient) / (alpha * sum);
  }
  if (gamma == 2) return 0.5 * inverse;
  if (gamma == 3) return (2 * alpha2 / (1 + alpha2) + inverse * inverse) / (4 * h);
  // Of large alpha only alpha^-2 is squared.
  const double scale = std::max(1.0, alpha2);
  const double q = 8 * (alpha2 / scale * alpha2 + alpha2 / scale + 1 / scale);
  const double y = 0.5 * inverse * inverse;
  return (6 * (alpha2 / scale) * alpha2 / h + (1.5 * alpha2 / scale + 0.25 * q * y * (1 + y)) / (h * h * h)) / q;
}

ModelSpec GtrProfile::spec() {
  ModelSpec spec{.type = "gtr",
                 .doc =
                     "generalized Trowbridge-Reitz; masking in closed form for gamma = 1, 2, 3, 4, else by quadrature",
                 .source = "Burley 2012; Akenine-Moller et al. 2018, Eqs. 9.46-9.47; Dimov 2015",
                 .parameters = isotropic_roughness({.min = 1e-6, .max = 1e6}, "roughness"),
                 .alternatives = {{"alpha"}, {"roughness"}}};
  spec.parameters.push_back(
      {.key = "gamma", .bounds = {.min = 0, .max = 1e3, .open_min = true}, .doc = "exponent of the tail; 2 is GGX"});
  return spec;
}

GtrLobe::GtrLobe(double alpha_is, double gamma_is) : alpha(alpha_is), gamma(gamma_is) {
  const double log_alpha2 = 2 * std::log(alpha);
  // Of k and k alpha^(-2 gamma) the one whose terms have the same sign.
  const double log_k =
      alpha >= 1 ? gtr_log_normalization(alpha, gamma) : log_phi(-log_alpha2) - log_phi((gamma - 1) * log_alpha2);
  log_peak = log_k - std::log(std::numbers::pi);
}

double GtrLobe::log_density(double sin2, double z2) const {
  const double above = (alpha - 1) * (alpha + 1);
  return log_peak - gamma * (alpha >= 1 ? std::log1p(above * z2) : std::log1p(-above / (alpha * alpha) * sin2));
}

double GtrLobe::log_p22(double r2) const { return log_density(1 / (1 + 1 / r2), 1 / (1 + r2)) - 2 * std::log1p(r2); }

double GtrLobe::median_slope() const {
  const double log_alpha2 = 2 * std::log(alpha);
  if (log_alpha2 == 0) return 1;
  // v^(1 - gamma) is the mean of what it is at both ends, alpha^(2 (1 - gamma)) and 1.
  const double x = (1 - gamma) * log_alpha2;
  const double log_mean = std::max(x, 0.0) + std::log(0.5 + 0.5 * std::exp(-std::fabs(x)));
  const double log_v = std::fabs(x) < 1e-5 ? (0.5 + x / 8) * log_alpha2 : log_mean / (1 - gamma);
  return alpha * std::sqrt(-std::expm1(log_v - log_alpha2) / std::expm1(log_v));
}

double GtrLobe::slope_within(double u) const {
  const double log_alpha2 = 2 * std::log(alpha);
  if (log_alpha2 == 0) return std::sqrt(u / (1 - u));
  // v^g = (1 - u) alpha^(2 g) + u with g = 1 - gamma, as ln(v / alpha^2) and, where v is near 1, as ln v itself.
  const double g = 1 - gamma;
  const double log_ratio = g == 0 ? -u * log_alpha2 : log_mean_of_powers(u, -g * log_alpha2) / g;
  double log_v = log_alpha2 + log_ratio;
  if (std::fabs(log_v) < 0.5) log_v = g == 0 ? (1 - u) * log_alpha2 : log_mean_of_powers(1 - u, g * log_alpha2) / g;
  return alpha * std::sqrt(std::expm1(log_ratio) / -std::expm1(log_v));
}

GtrProfile GtrProfile::from(const Values& values) {
  const GtrLobe lobe(alpha_from(values), values.number("gamma"));
  const double alpha2 = lobe.alpha * lobe.alpha;
  const double log_alpha2 = std::log(alpha2);
  return {lobe, ALambdaTable([=](double t2) { return lobe.log_p22(alpha2 * t2) + log_alpha2; })};
}

double GtrProfile::a_lambda(double a) const {
  const double gamma = lobe.gamma;
  const bool closed = gamma == 1 || gamma == 2 || gamma == 3 || gamma == 4;
  return closed ? gtr_a_lambda_closed(lobe.alpha, static_cast<int>(gamma), a) : table(a);
}

} // namespace brdfplot
