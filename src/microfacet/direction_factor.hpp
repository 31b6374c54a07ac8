/// \file
/// The factor lambda that correlates masking and shadowing by direction (Heitz 2014, Eqs. 100 and 101): where it is 0,
/// the direction that sees more facets sees all that the other does; where it is 1, heights alone correlate them.
#pragma once

#include "microfacet/direction_factor_coefficients.hpp"
#include "microfacet/slopes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brdfplot {

enum class DirectionFactor { ashikhmin, ginneken, fitted };

/// The names of `DirectionFactor`, in its order.
inline const std::vector<std::string>& direction_factor_names() {
  static const std::vector<std::string> names = {"ashikhmin", "ginneken", "fitted"};
  return names;
}

/// Two directions as a factor sees them.
struct DirectionPair {
  double azimuth_difference = 0; ///< phi in [0, pi], of the directions as azimuth_after_stretching() says
  Projection o{};                ///< c > 0
  Projection i{};
};

/// lambda and 1 - lambda, neither with a cancellation: where one side is grazing, 1 - lambda weighs the smaller G1
/// against a product that is smaller still.
struct DirectionCorrelation {
  double lambda = 0;
  double complement = 1;
};

/// Whether phi is the azimuth between the directions as they are on the surface of unit roughness
/// (SlopeMap::on_unit_surface()).
constexpr bool azimuth_after_stretching(DirectionFactor which) { return which == DirectionFactor::fitted; }

/// lambda(omega_o, omega_i) on surfaces of Gaussian heights and autocorrelation, whose slopes are Beckmann's:
///
///   lambda = (1 - exp(-(rate + grazing_rate / a_s) S)) (1 - dip sin^2(phi / 2) a_s / ((a_s + onset) (1 + fall a_g)))
///   S = H(phi - p) - H(-p),  H(t) = (t + sqrt(t^2 + 4 w^2)) / 2,  p = threshold (a_s - a_g),  w = width p
///
/// a = c / s = cot theta / alpha of the steeper direction, a_s, and of the more grazing one, a_g. Up to an azimuth of p
/// the steeper ray stays above the other, and lambda is all but 0; from there S grows as phi - p does. The dip: behind,
/// a lower point is hidden from both. Roughness, anisotropy, correlation and shear need no term: an affine map that
/// keeps the vertical changes neither what sees what, nor a; phi is taken before that map.
///
/// Source: fitted to rays on such surfaces by tests/reference/fit_direction_factor.cpp, for a in [0.05, 0.8] (alpha =
/// 0.6: theta in [64.4, 88.3] degrees) and every phi; docs/direction_factor.md has its errors beside those of the
/// published factors. It extrapolates for other a, and for other distributions, with the width of their slopes as
/// alpha. Symmetric, in [0, 1], and continuous for c > 0. 0 at phi = 0 and at the normal, which has no azimuth. As both
/// directions become grazing at phi > 0, it tends to 1.
inline DirectionCorrelation
fitted_direction_correlation(const DirectionPair& pair,
                             const DirectionFactorCoefficients& k = fitted_direction_factor) {
  const double phi = pair.azimuth_difference;
  const double larger = std::max(pair.o.s, pair.i.s), smaller = std::min(pair.o.s, pair.i.s);
  if (!(phi > 0 && larger > 0)) return {};
  const double cross = pair.o.c * pair.i.s - pair.i.c * pair.o.s;
  const Projection& steep = cross > 0 ? pair.o : pair.i;
  const Projection& grazing = cross > 0 ? pair.i : pair.o;

  // S = share phi. Angles times s_o s_i / larger, which keeps p finite, and the difference in S written as a sum.
  const double p = k.threshold * (std::fabs(cross) / larger), width = 2 * k.width * p, azimuth = smaller * phi;
  const double share = 0.5 + 0.5 * (azimuth - 2 * p) / (std::hypot(azimuth - p, width) + std::hypot(p, width));
  const double exponent = (k.rate + k.grazing_rate * (steep.s / steep.c)) * (share * phi);

  const double sine = std::sin(0.5 * phi);
  const double onset = steep.c / (steep.c + k.onset * steep.s), fall = grazing.s / (grazing.s + k.fall * grazing.c);
  const double dip = k.dip * (sine * sine) * onset * fall;
  const double rise = -std::expm1(-exponent);
  return {rise * (1 - dip), std::exp(-exponent) + rise * dip};
}

/// lambda of phi alone: 1 - exp(-7.3 phi^2) (Ashikhmin et al. 2000; RTR4, Eq. 9.29) or 4.41 phi / (4.41 phi + 1) (van
/// Ginneken et al. 1998; RTR4, Eq. 9.30); or the one above, of both directions.
inline DirectionCorrelation direction_correlation(DirectionFactor which, const DirectionPair& pair) {
  const double phi = pair.azimuth_difference;
  switch (which) {
  case DirectionFactor::ashikhmin: return {-std::expm1(-7.3 * phi * phi), std::exp(-7.3 * phi * phi)};
  case DirectionFactor::ginneken: return {4.41 * phi / (4.41 * phi + 1), 1 / (4.41 * phi + 1)};
  case DirectionFactor::fitted: break;
  }
  return fitted_direction_correlation(pair);
}

} // namespace brdfplot
