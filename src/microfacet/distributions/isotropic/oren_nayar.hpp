/// \file
/// Gaussian in the angle, by the ground that facets cover (Oren and Nayar 1994).
#pragma once

#include "microfacet/distributions/isotropic.hpp"

namespace brdfplot {

/// D = N exp(-theta_m^2 / (2 sigma^2)) / cos theta_m. Oren and Nayar's slope-area distribution P counts the ground that
/// facets cover, not their own area: P = D cos theta_m, with int P = 1, so that
/// 1 / N = 2 pi int_0^(pi/2) exp(-theta^2 / (2 sigma^2)) sin(theta) dtheta.
///
/// P does not vanish at the horizon. Slopes fall like r^-3 there, the area of the facets and with it the mean slope and
/// Smith's Lambda are infinite for every sigma; V-cavities, which Oren and Nayar assume, see a finite part of it.
struct OrenNayarProfile {
  double sigma = 0.5; ///< radians
  double peak = 1;    ///< N

  static ModelSpec spec();
  static OrenNayarProfile from(const Values& values);

  static constexpr bool infinite_mean_slope = true;
  double width() const;
  double p22(double r2) const; ///< N exp(-theta_m^2 / (2 sigma^2)) (1 + r2)^(-3/2)
  /// Grows without bound towards the horizon; normals nearer to it than 1e-300 count as there.
  double density(double sin2, double z) const;
  /// Infinite but at the normal. build() does not let a material ask for it.
  double a_lambda(double a) const;
};

using OrenNayar = Isotropic<OrenNayarProfile>;

} // namespace brdfplot
