/// \file
/// The velvet distribution of Neubelt and Pettineo (2013): an inverted Gaussian on a uniform base.
#pragma once

#include "microfacet/distributions/isotropic.hpp"

#include <array>
#include <utility>

namespace brdfplot {

/// D = (1 + k exp(-cot^2 / alpha^2) / sin^4) / (pi (1 + k alpha^2)) (RTR4, Eq. 9.73, whose exponent is to be read as
/// negative: with it int D cos = 1 for every k and alpha). It is the sum of uniform normals, which are GGX with alpha =
/// 1, and of InverseGaussianShape with alpha' = 1 / alpha, weighted 1 to k alpha^2.
struct VelvetProfile {
  double alpha = 0.5;
  double base = 0.5;     ///< weight of the uniform normals, 1 / (1 + k alpha^2)
  double inverted = 0.5; ///< weight of the inverted Gaussian, not as 1 - base, of which nothing would be left

  static ModelSpec spec();
  static VelvetProfile from(const Values& values);

  double width() const { return base > 0 ? 1 : 1 / alpha; }
  double p22(double r2) const;
  /// The slope within which a share u of the ground lies, of one of parts().
  double slope_within(double u) const {
    return base > 0 ? std::sqrt(u / (1 - u)) : 1 / (alpha * std::sqrt(-std::log(u)));
  }
  double density(double sin2, double z) const;
  /// Exact, since masked areas add. The base is GGX with alpha = 1.
  double a_lambda(double a) const;

  /// What it is the sum of, with the weights: slopes of 1 and of 1 / alpha, which no one frame sees.
  std::array<std::pair<double, VelvetProfile>, 2> parts() const {
    return {std::pair{base, VelvetProfile{alpha, 1, 0}}, {inverted, VelvetProfile{alpha, 0, 1}}};
  }
};

using Velvet = Isotropic<VelvetProfile>;

} // namespace brdfplot
