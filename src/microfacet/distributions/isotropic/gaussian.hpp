/// \file
/// Gaussian in the angle (Blinn 1977; Torrance and Sparrow 1967).
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/isotropic.hpp"

namespace brdfplot {

/// D = N exp(-(theta_m / alpha)^2). Blinn prints an arbitrary factor for N; here int D cos = 1, so that
/// 1 / N = pi int_0^(pi/2) exp(-(theta / alpha)^2) sin(2 theta) dtheta.
struct GaussianProfile {
  double alpha = 0.5;  ///< m of Cook and Torrance (1982), radians
  double log_peak = 0; ///< ln N
  ALambdaTable table;

  static ModelSpec spec();
  static GaussianProfile from(const Values& values);

  double width() const { return width(alpha); }
  static double width(double alpha) { return std::tan(std::fmin(alpha, 1)); }
  double p22(double r2) const;
  double density(double sin2, double z) const;
  /// From a table of the quadrature of these slopes; relative error 1e-10 of all that is above 1e-290.
  double a_lambda(double a) const { return table(a); }
};

using Gaussian = Isotropic<GaussianProfile>;

} // namespace brdfplot
