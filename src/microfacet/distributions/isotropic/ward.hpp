/// \file
/// The distribution of Ward's model as Kelemen and Szirmay-Kalos (2001) read it, made a distribution of normals.
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/isotropic.hpp"

namespace brdfplot {

/// D = N exp(-tan^2 / alpha^2) / cos^3. Kelemen and Szirmay-Kalos (2001), Eq. 4, print it with N = 1 / (pi alpha^2),
/// alpha their m: then int D = 1, a density of normals over solid angle. A distribution of normals has int D cos = 1:
/// N = 1 / (pi^(3/2) alpha erfcx(1 / alpha)) here, which is larger (by 4 % at alpha = 0.3).
struct WardProfile {
  double alpha = 0.5;
  double log_peak = 0; ///< ln N
  ALambdaTable table;

  static ModelSpec spec();
  static WardProfile from(const Values& values);

  double width() const { return alpha; }
  double p22(double r2) const; ///< N exp(-r2 / alpha^2) / sqrt(1 + r2)
  double density(double sin2, double z) const;
  /// From a table of the quadrature of these slopes; relative error 1e-10 of all that is above 1e-290.
  double a_lambda(double a) const { return table(a); }
};

using Ward = Isotropic<WardProfile>;

} // namespace brdfplot
