/// \file
/// Generalized Trowbridge-Reitz (Burley 2012), with its own Smith masking by quadrature.
#pragma once

#include "microfacet/slopes.hpp"
#include "microfacet/smith_quadrature.hpp"

namespace brdfplot {

/// D = k / (pi (1 + (alpha^2 - 1) cos^2)^gamma) (RTR4, Eqs. 9.46-9.47); gamma = 2 is GGX. Not shape-invariant.
struct Gtr {
  SlopeMap slopes; ///< isotropic
  double gamma = 2;
  double log_k = 0;

  static ModelSpec spec();
  static Gtr from(const Values& values);
  static constexpr bool shape_invariant = false;

  /// k / pi (1 + r^2)^(gamma - 2) / (r^2 + alpha^2)^gamma.
  double p22(double slope_x, double slope_y) const;
  /// With sin^2 + alpha^2 cos^2 in place of 1 + (alpha^2 - 1) cos^2, which cancels near the normal.
  double density(const Direction& omega_m) const;
  /// c Lambda with Lambda by quadrature of these slopes; relative error 1e-10. Domain c > 0 (0 elsewhere).
  double masked_area(const Projection& p) const;

  void masked_areas(const double* c, const double* s, double* t, std::size_t n) const {
    masked_areas_by_quadrature(*this, c, s, t, n);
  }
  void densities(const kernels::Vectors<double>& m, double* d, std::size_t n) const {
    for (std::size_t k = 0; k < n; ++k) d[k] = density({m.x[k], m.y[k], m.z[k]});
  }

private:
  double log_p22(double r2) const; ///< ln P22 at squared slope r2
};

/// ln k of RTR4, Eq. 9.47, continuous through gamma = 1 and alpha = 1: with phi(x) = (e^x - 1) / x and L = ln alpha^2,
/// k = phi(L) / phi((1 - gamma) L).
double gtr_log_normalization(double alpha, double gamma);

} // namespace brdfplot
