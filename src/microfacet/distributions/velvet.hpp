/// \file
/// The velvet distribution of Neubelt and Pettineo (2013): an inverted Gaussian on a uniform base.
#pragma once

#include "microfacet/isotropic.hpp"

namespace brdfplot {

/// D = (1 + k exp(-cot^2 / alpha^2) / sin^4) / (pi (1 + k alpha^2)) (RTR4, Eq. 9.73, whose exponent is to be read as
/// negative: with it int D cos = 1 for every k and alpha). It is the sum of uniform normals, which are GGX with alpha =
/// 1, and of InverseGaussianShape with alpha' = 1 / alpha, weighted 1 to k alpha^2.
struct VelvetProfile {
  double alpha = 0.5;
  double amplitude = 4; ///< k

  static ModelSpec spec();
  static VelvetProfile from(const Values& values);

  double width() const { return 1; } ///< of the base; the rest reaches to slopes of 1 / alpha
  double base_weight() const { return 1 / (1 + amplitude * alpha * alpha); }
  double p22(double r2) const;
  double density(double sin2, double z) const;
  /// Exact, since masked areas add. The base is GGX with alpha = 1.
  double a_lambda(double a) const;
};

using Velvet = Isotropic<VelvetProfile>;

} // namespace brdfplot
