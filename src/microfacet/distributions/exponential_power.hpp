/// \file
/// The exponential power distribution of slopes (Holzschuch and Pacanowski 2017).
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/shape_invariant.hpp"

namespace brdfplot {

/// P22 = p exp(-t2^p) / (pi Gamma(1 / p)) at alpha = 1 (their beta); p = 1 is Beckmann, p = 1/2 falls like exp(-t).
struct ExponentialPowerShape {
  double power = 1;
  double log_peak = 0; ///< ln of P22 at 0
  double median = 1;   ///< slope within which half of the ground is, over that of p = 1
  ALambdaTable table;

  static ModelSpec about();
  static ExponentialPowerShape from(const Values& values);

  double density(double t2) const;
  /// By the inverse of the incomplete gamma function (Holzschuch and Pacanowski 2017, Eqs. 49-50).
  double slope_within(double u) const;
  /// 1 for p = 1, 1e5 for p = 0.1.
  double typical_slope() const { return median; }
  double scaled_density(double n2, double z2) const;
  /// a Lambda(a) from a table of the quadrature of these slopes: there is no general closed form. Domain a in [0,
  /// infinity]; relative error 1e-10 of all that is above 1e-290.
  double a_lambda(double a) const { return table(a); }
};

using ExponentialPower = ShapeInvariant<ExponentialPowerShape>;

} // namespace brdfplot
