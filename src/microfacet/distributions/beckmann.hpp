/// \file
/// Beckmann: Gaussian slopes (Heitz 2014, Eqs. 67-69, 81-83; Akenine-Moller et al. 2018, Eqs. 9.35, 9.38, 9.52).
#pragma once

#include "microfacet/beckmann_lambda.hpp"
#include "microfacet/distributions/shape_invariant.hpp"
#include "microfacet/visible_slopes.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot {

struct BeckmannShape {
  static ModelSpec about() {
    return {.type = "beckmann",
            .doc = "Gaussian slopes; alpha is sqrt(2) times their root mean square",
            .source = "Beckmann and Spizzichino 1963; Heitz 2014, Eqs. 67-69, 81-83; Akenine-Moller et al. 2018, Eqs. "
                      "9.35, 9.38, 9.52"};
  }

  /// exp(-t2) / pi (Eq. 67 with alpha = 1).
  static double density(double t2) { return std::exp(-t2) * std::numbers::inv_pi; }

  /// exp(-n2 / z2) / (pi z2^2), which is 0 at grazing however fast 1 / z2^2 grows.
  static double scaled_density(double n2, double z2) {
    const double numerator = std::exp(-n2 / z2);
    return numerator > 0 ? numerator * std::numbers::inv_pi / (z2 * z2) : 0;
  }

  /// a Lambda(a) of Eq. 69; see beckmann_lambda.hpp for the form that does not cancel.
  static double a_lambda(double a) { return beckmann_a_lambda(a); }

  static constexpr kernels::Distribution kernel = kernels::Distribution::beckmann;
  static void masked_areas(const double* c, const double* s, double* t, std::size_t n) {
    kernels::masked_area_beckmann(c, s, t, n);
  }
  static void densities(const kernels::Stretch& stretch, const kernels::Vectors<double>& m, double* d, std::size_t n) {
    kernels::d_beckmann(stretch, m, d, n);
  }

  static constexpr bool gaussian_slopes = true;
  static constexpr const char* simulated_surface = "gaussian";

  static double slope_within(double u) { return std::sqrt(-std::log1p(-u)); }

  /// By inversion of both marginals (after Heitz and d'Eon 2014).
  static UnitSlope visible_slope(double c, double s, double u_facing, double u_across) {
    return {visible_gaussian(c, s, u_facing), gaussian(u_across)};
  }

  /// Slopes of a Gaussian are independent along any two axes.
  template <class Generator>
  static UnitSlope sample_visible_slope(double c, double s, Generator& random) {
    const double radius = std::sqrt(-std::log(random.uniform()));
    const double across = radius * std::cos(2 * std::numbers::pi * random.uniform());
    return {sample_visible_gaussian(c / s, random), across};
  }
};

using Beckmann = ShapeInvariant<BeckmannShape>;

} // namespace brdfplot
