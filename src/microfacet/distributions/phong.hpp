/// \file
/// The Phong distribution of normals (Walter et al. 2007), with its own Smith masking by quadrature.
#pragma once

#include "microfacet/slopes.hpp"
#include "microfacet/smith_quadrature.hpp"

namespace brdfplot {

/// D = (n + 2) / (2 pi) cos^n theta_m; not shape-invariant. Domain n > -1 (the mean slope is infinite from there down).
struct Phong {
  SlopeMap slopes; ///< isotropic, with the equivalent alpha = sqrt(2 / (n + 2)) (Walter et al. 2007)
  double exponent = 0;

  static ModelSpec spec();
  static Phong from(const Values& values);
  static constexpr bool shape_invariant = false;

  /// (n + 2) / (2 pi) (1 + r^2)^(-(n + 4) / 2).
  double p22(double slope_x, double slope_y) const;
  /// cos^n through log1p of tan^2, exact near the normal however large n is.
  double density(const Direction& omega_m) const;
  /// c Lambda with Lambda by quadrature of these slopes; relative error 1e-10. Domain c > 0 (0 elsewhere).
  double masked_area(const Projection& p) const;

  void masked_areas(const double* c, const double* s, double* t, std::size_t n) const {
    masked_areas_by_quadrature(*this, c, s, t, n);
  }
  void densities(const kernels::Vectors<double>& m, double* d, std::size_t n) const {
    for (std::size_t k = 0; k < n; ++k) d[k] = density({m.x[k], m.y[k], m.z[k]});
  }
};

} // namespace brdfplot
