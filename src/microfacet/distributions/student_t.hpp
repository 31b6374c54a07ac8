/// \file
/// Student's t distribution of slopes (Ribardiere et al. 2017): a tail between those of GGX and Beckmann, or longer.
#pragma once

#include "microfacet/distributions/shape_invariant.hpp"

namespace brdfplot {

/// P22 = (1 + t2 / (gamma - 1))^-gamma / pi at alpha = 1; gamma = 2 is GGX, gamma -> infinity Beckmann. Domain
/// gamma > 3/2: from there down the mean slope, and with it Lambda, is infinite.
struct StudentTShape {
  double gamma = 2;
  double excess = 0.5; ///< gamma - 3/2, which gamma near 3/2 has not the digits for
  double scale = 0.5;  ///< a Lambda(a) at a = 0: sqrt(g / pi) Gamma(g + 1/2) / (Gamma(g) (2 gamma - 3)), g = gamma - 1

  static ModelSpec about();
  static StudentTShape from(const Values& values) { return of_excess(values.number("gamma") - 1.5); }
  /// \pre excess > 0
  static StudentTShape of_excess(double excess);

  double density(double t2) const;
  double slope_within(double u) const { return std::sqrt((gamma - 1) * std::expm1(-std::log1p(-u) / (gamma - 1))); }
  /// Where gamma < 2, D grows without bound towards the horizon; normals nearer to it than 1e-150 count as there.
  double scaled_density(double n2, double z2) const;
  /// a Lambda(a), with g = gamma - 1, x = a^2 / (g + a^2), w = 1 - x and I the regularised incomplete beta function:
  ///   a Lambda = scale w^(gamma - 3/2) - (a / 2) I_w(g, 1/2) = scale w^(gamma - 3/2) 2F1(gamma - 3/2, 1; 1/2; x) - a
  ///   / 2.
  /// The exact integral; Ribardiere et al. (2017, Eqs. 22-23) fit it. For a < 1.1 the second form, by the series.
  /// Beyond, the terms cancel, more and more: there I_w is Gauss's continued fraction of 2F1(1/2, 1; g + 1; -g / a^2),
  /// all of whose coefficients are positive, and its first step is subtracted by hand. Domain a in [0, infinity];
  /// relative error at most 1e-13 and that of the power w^(gamma - 3/2), 2^-52 times its logarithm.
  double a_lambda(double a) const;
};

using StudentT = ShapeInvariant<StudentTShape>;

} // namespace brdfplot
