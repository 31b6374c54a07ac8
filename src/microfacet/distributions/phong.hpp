/// \file
/// The Phong distribution of normals (Walter et al. 2007), with its own Smith masking by quadrature.
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/isotropic.hpp"

namespace brdfplot {

/// D = (n + 2) / (2 pi) cos^n theta_m; not shape-invariant. Domain n > -1 (the mean slope is infinite from there down).
struct PhongProfile {
  double exponent = 0;
  double alpha = 1; ///< of the like Beckmann surface, sqrt(2 / (n + 2)) (Walter et al. 2007)
  ALambdaTable table;

  static ModelSpec spec();
  static PhongProfile from(const Values& values);

  double width() const { return alpha; }
  double p22(double r2) const; ///< (n + 2) / (2 pi) (1 + r2)^(-(n + 4) / 2)
  /// cos^n through log1p of tan^2, exact near the normal however large n is.
  double density(double sin2, double z) const;
  /// From a table of the quadrature of these slopes; relative error 1e-10.
  double a_lambda(double a) const { return table(a); }
};

using Phong = Isotropic<PhongProfile>;

} // namespace brdfplot
