#include "analysis/integrals.hpp"
#include "choice/methods/problems.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot::choice {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

/// The integral over the light's azimuth of rho, in closed form: k averages to 0, its part above and below 0 to 2 and
/// -2, 1 - |k| to 2 pi - 4. With the light's sin cos, of which the cosine is left in tan beta cos theta_i.
double oren_nayar_ring(double sigma, double theta_o, double theta_i) {
  const double s = sigma * sigma, rough = s / (s + 0.09);
  const double steep = std::max(theta_o, theta_i), flat = std::min(theta_o, theta_i);
  const double f = 2 * flat / std::numbers::pi, both = f * 2 * steep / std::numbers::pi;
  const double once = 2 * std::numbers::pi * (1 - 0.5 * s / (s + 0.33)) +
                      0.45 * rough * 2 * f * f * f * std::tan(flat) +
                      0.125 * rough * both * both * (2 * std::numbers::pi - 4) * std::tan((steep + flat) / 2);
  const double twice = 2 * std::numbers::pi * 0.17 * s / (s + 0.13);
  return (once + twice) * std::numbers::inv_pi * std::sin(theta_i) * std::cos(theta_i);
}

/// Cut where alpha and beta change places.
Exact exact_oren_nayar_albedo(std::span<const double> x) {
  const auto ring = [&](double theta_i) { return oren_nayar_ring(x[0], x[1], theta_i); };
  const auto part = [&](double from, double to) {
    return to > from ? boost::math::quadrature::gauss_kronrod<double, 31>::integrate(ring, from, to, 12, 1e-13) : 0.0;
  };
  return {part(0, x[1]) + part(x[1], quarter_turn), 0};
}

void oren_nayar_albedo(std::size_t n, const double* const* in, double* out) {
  for (std::size_t i = 0; i < n; ++i) {
    TermDescription term;
    term.type = "oren_nayar";
    term.values.set("albedo", 1.0);
    term.values.set("sigma", in[0][i]);
    out[i] = compute(Integral::albedo, build(term), from_angles(in[1][i], 0)).value;
  }
}

} // namespace

Problem albedo_oren_nayar() {
  Problem p{.name = "albedo_oren_nayar",
            .doc = "What a rough white wall reflects",
            .source = "Oren and Nayar 1994, Eq. 30",
            .inputs = {{"sigma", "standard deviation of the facets' inclination, rad", 0, 1},
                       {"theta_o", "polar angle of the viewer", 0, 1.57}},
            .exact = exact_oren_nayar_albedo,
            .least = 0,
            .albedo = true,
            .exact_error = 1e-12,
            .samples = 100};
  p.methods.push_back({.name = "full",
                       .doc = "the fit with the light that is reflected twice, integrated",
                       .source = "Oren and Nayar 1994, Eq. 30",
                       .kind = Kind::printed,
                       .run = Run<double>(oren_nayar_albedo)});
  return p;
}

} // namespace brdfplot::choice
