/// \file
/// The inverted Gaussian of slopes that the velvet distribution contains.
#pragma once

namespace brdfplot {

/// P22 = exp(-1 / t2) / (pi t2^2) at unit roughness: the normals exp(-cot^2 / b^2) / (pi b^2 sin^4) of Ashikhmin et al.
/// (2000), which are shape-invariant with alpha = 1 / b.
struct InverseGaussianShape {
  static double density(double t2);
  /// exp(-z2 / n2) / (pi n2^2).
  static double scaled_density(double n2, double z2);
  /// a Lambda(a) = (a / 2) (L(1 / a^2) - 1), L(x) = 1F1(-1/2; 1; -x) = e^(-x/2) ((1 + x) I_0(x/2) + x I_1(x/2)): the
  /// second integral of the slopes along one axis, P2(x) = 1F1(3/2; 2; -1 / x^2) / (2 x^3), summed term by term. By the
  /// series for a > 1 (where the difference would cancel), by Bessel functions, and by the asymptotic series for
  /// a < 1/8. Domain a in [0, infinity]: 1 / sqrt(pi) at 0, like 1 / (4 a) at infinity. Relative error < 2e-15.
  static double a_lambda(double a);
};

} // namespace brdfplot
