#include "brdf/oren_nayar.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

namespace {

using std::numbers::pi;

/// The two directions as the fits see them.
struct Pair {
  double sin_o, sin_i;
  double alpha, beta;
  double cos_azimuth = 0; ///< k

  Pair(const Direction& o, const Direction& i) : sin_o(std::hypot(o.x, o.y)), sin_i(std::hypot(i.x, i.y)) {
    const double theta_o = std::atan2(sin_o, o.z), theta_i = std::atan2(sin_i, i.z);
    alpha = std::max(theta_o, theta_i);
    beta = std::min(theta_o, theta_i);
    // At the normal nothing depends on it.
    if (beta > 0) cos_azimuth = std::clamp((o.x / sin_o) * (i.x / sin_i) + (o.y / sin_o) * (i.y / sin_i), -1.0, 1.0);
  }
};

/// sin alpha - (2 beta / pi)^3 by what both are short of 1; `above_*`: the angles above the horizon.
double backward_sine(double above_alpha, double above_beta) {
  const double half_sine = std::sin(0.5 * above_alpha);
  const double q = 2 / pi * above_beta;
  return q * (3 - q * (3 - q)) - 2 * half_sine * half_sine;
}

} // namespace

OrenNayarParts oren_nayar_parts(OrenNayarFit fit, double sigma, const Direction& omega_o, const Direction& omega_i) {
  if (!(omega_o.z > 0 && omega_i.z > 0)) return {};
  const Pair p(omega_o, omega_i);
  const double k = p.cos_azimuth;
  const double s = sigma * sigma;
  const double sin_alpha = std::max(p.sin_o, p.sin_i);
  const double tan_beta = std::min(p.sin_o, p.sin_i) / std::max(omega_o.z, omega_i.z);
  const double c1 = 1 - 0.5 * s / (s + 0.33);
  const double rough = s / (s + 0.09);
  if (fit == OrenNayarFit::qualitative) return {c1 + 0.45 * rough * std::max(0.0, k) * sin_alpha * tan_beta, 0};

  const double above_alpha = std::atan2(std::min(omega_o.z, omega_i.z), sin_alpha);
  const double above_beta = std::atan2(std::max(omega_o.z, omega_i.z), std::min(p.sin_o, p.sin_i));
  const double c2 = 0.45 * rough * (k >= 0 ? sin_alpha : backward_sine(above_alpha, above_beta));
  const double angles = 4 / (pi * pi) * p.alpha * p.beta;
  const double c3 = 0.125 * rough * angles * angles;
  const double tan_mean = (p.sin_o + p.sin_i) / (omega_o.z + omega_i.z);
  const double once = c1 + k * c2 * tan_beta + (1 - std::fabs(k)) * c3 * tan_mean;
  if (fit == OrenNayarFit::direct) return {once, 0};
  const double half = 2 / pi * p.beta;
  return {once, 0.17 * s / (s + 0.13) * (1 - k * half * half)};
}

double oren_nayar_brdf(OrenNayarFit fit, double sigma, const Direction& omega_o, const Direction& omega_i) {
  const OrenNayarParts parts = oren_nayar_parts(fit, sigma, omega_o, omega_i);
  return (parts.once + parts.twice) * std::numbers::inv_pi;
}

} // namespace brdfplot
