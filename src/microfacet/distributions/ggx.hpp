/// \file
/// GGX, also known as Trowbridge-Reitz (Heitz 2014, Eqs. 70-72, 84-86; Akenine-Moller et al. 2018,
/// Eqs. 9.41-9.42, 9.53).
#pragma once

#include "microfacet/distributions/shape_invariant.hpp"
#include "microfacet/visible_slopes.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot {

struct GgxShape {
  static constexpr bool infinite_variance = true;
  static ModelSpec about() {
    return {.type = "ggx",
            .doc = "slopes with a long tail (Trowbridge-Reitz)",
            .source = "Trowbridge and Reitz 1975; Walter et al. 2007; Heitz 2014, Eqs. 70-72, 84-86; Akenine-Moller et "
                      "al. 2018, Eqs. 9.41-9.42, 9.53"};
  }

  /// 1 / (pi (1 + t2)^2) (Eq. 70 with alpha = 1).
  static double density(double t2) { return std::numbers::inv_pi / ((1 + t2) * (1 + t2)); }

  /// 1 / (pi (z2 + n2)^2): Eq. 71 without a division by cos theta_m.
  static double scaled_density(double n2, double z2) { return std::numbers::inv_pi / ((z2 + n2) * (z2 + n2)); }

  /// a Lambda(a) = 1 / (2 (a + sqrt(1 + a^2))): Eq. 72 without the difference that cancels for large a, and without the
  /// 1/a that is infinite at grazing. hypot keeps a^2 from overflowing.
  static double a_lambda(double a) { return 0.5 / (a + std::hypot(1.0, a)); }

  static constexpr kernels::Distribution kernel = kernels::Distribution::ggx;
  static void masked_areas(const double* c, const double* s, double* t, std::size_t n) {
    kernels::masked_area_ggx(c, s, t, n);
  }
  static void densities(const kernels::Stretch& stretch, const kernels::Vectors<double>& m, double* d, std::size_t n) {
    kernels::d_ggx(stretch, m, d, n);
  }

  static constexpr const char* simulated_surface = "ggx";

  static double slope_within(double u) { return std::sqrt(u / (1 - u)); }

  /// Reflected at its visible normals, a direction is spread evenly over a spherical cap (Dupuy and Benyoub 2023). With
  /// z its height there, h_z = z + c = (1 - u) (1 + c), which does not cancel at the rim of the cap.
  static UnitSlope visible_slope(double c, double s, double u_azimuth, double u_height) {
    const double phi = 2 * std::numbers::pi * u_azimuth;
    const double h_z = (1 - u_height) * (1 + c);
    const double versine = c > 0 ? s * s / (1 + c) : 1 - c;
    const double radius = std::sqrt(u_height * (1 + c) * (versine + h_z));
    return {(radius * std::cos(phi) + s) / h_z, radius * std::sin(phi) / h_z};
  }

  /// The same density by another map: of a disc, half of it scaled, to the half that is seen of a hemisphere (Heitz
  /// 2018). With t2' the point's height on the disc and h that of its rim, h_z = c z - s t2' would cancel at the rim;
  /// it is taken as a quotient there.
  static UnitSlope visible_slope_2018(double c, double s, double u_radius, double u_azimuth) {
    const double phi = 2 * std::numbers::pi * u_azimuth, radius = std::sqrt(u_radius), q = 0.5 * (1 + c);
    const double across = radius * std::cos(phi), place = radius * std::sin(phi);
    const double rim = std::sqrt((1 - across) * (1 + across)), above = 1 - u_radius;
    // rim - place and rim + place, whose product is 1 - radius^2.
    const double to_top = place > 0 ? above / (rim + place) : rim - place;
    const double to_bottom = place > 0 ? rim + place : above / (rim - place);
    const double height = rim - q * to_top, z = std::sqrt(q * to_top * (rim + height));
    const double sum = c * z - s * height;
    const double h_z = height < 0 ? (c * rim - height) * q * to_bottom / sum : s * height + c * z;
    return {(s * z - c * height) / h_z, across / h_z};
  }

  template <class Generator>
  static UnitSlope sample_visible_slope(double c, double s, Generator& random) {
    const double u_azimuth = random.uniform();
    const double u_height = random.uniform();
    return visible_slope(c, s, u_azimuth, u_height);
  }
};

using Ggx = ShapeInvariant<GgxShape>;

} // namespace brdfplot
