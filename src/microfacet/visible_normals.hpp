/// \file
/// Random normals as they are seen from a direction: samples of D_v(m) = <v, m> D(m) / sigma(v) (Heitz 2014, Eq. 16),
/// from above and, for the rays of a random walk, from below the horizon too.
#pragma once

#include "base/random.hpp"
#include "math/direction.hpp"
#include "microfacet/distributions/beckmann.hpp"
#include "microfacet/distributions/ggx.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot {

/// x with the density proportional to (a + x)+ e^(-x^2): the visible slopes of a Gaussian profile, at any signed a =
/// cot theta. Exact, by rejection; at least a third of the proposals is accepted.
inline double sample_visible_gaussian(double a, Random& random) {
  const auto exponential = [&] { return -std::log(random.uniform()); };
  for (;;) {
    if (a >= 0) {
      // (a + x)+ <= a + |x|: a Gaussian, or a Rayleigh variable of either sign.
      const bool gaussian = random.uniform() * (1 + a * std::sqrt(std::numbers::pi)) >= 1;
      const double radius = std::sqrt(exponential());
      const double x = radius * (gaussian                 ? std::cos(2 * std::numbers::pi * random.uniform())
                                 : random.uniform() < 0.5 ? 1.0
                                                          : -1.0);
      if (x >= 0 || random.uniform() * (1 - x / a) < 1 + x / a) return x; // a may be infinite
    } else if (a > -0.75) {
      // (a + x)+ <= x beyond -a.
      const double x = std::sqrt(a * a + exponential());
      if (random.uniform() * x < a + x) return x;
    } else {
      // With x = y - a the density is y e^(2 a y) e^(-y^2): a gamma variable, times what is at most 1.
      const double y = (exponential() + exponential()) / (-2 * a);
      if (random.uniform() < std::exp(-y * y)) return y - a;
    }
  }
}

/// A slope of unit roughness, as seen from the unit vector w in the space of unit roughness. `facing` is the slope
/// along w's azimuth with its sign such that it grows towards w, `across` the one at right angles.
struct UnitSlope {
  double facing;
  double across;
};

template <class Shape>
UnitSlope sample_visible_slope(double c, double s, Random& random);

template <>
inline UnitSlope sample_visible_slope<BeckmannShape>(double c, double s, Random& random) {
  // Slopes of a Gaussian are independent along any two axes.
  const double radius = std::sqrt(-std::log(random.uniform()));
  const double across = radius * std::cos(2 * std::numbers::pi * random.uniform());
  return {sample_visible_gaussian(c / s, random), across};
}

/// Reflected at its visible normals, w is spread evenly over a spherical cap (Dupuy and Benyoub 2023).
template <>
inline UnitSlope sample_visible_slope<GgxShape>(double c, double s, Random& random) {
  const double phi = 2 * std::numbers::pi * random.uniform();
  const double z = 1 - random.uniform() * (1 + c);
  const double radius = std::sqrt(std::fmax(0.0, (1 - z) * (1 + z)));
  const double h_z = z + c;
  return {(radius * std::cos(phi) + s) / h_z, radius * std::sin(phi) / h_z};
}

/// A visible normal. v: any direction but (0, 0, -1) in the space of unit roughness, from where no facet is seen.
template <class Shape>
Direction sample_visible_normal(const SlopeMap& slopes, const Direction& v, Random& random) {
  const auto [x, y] = slopes.on_unit_surface(v);
  const auto [c, s] = slopes.project(v);
  const double norm = std::hypot(s, c);
  const double along_x = s > 0 ? x / s : 1;
  const double along_y = s > 0 ? y / s : 0;
  const UnitSlope slope = sample_visible_slope<Shape>(c / norm, s / norm, random);
  // The slope of the surface falls where the facet faces v.
  const double u = -(slope.facing * along_x - slope.across * along_y);
  const double w = -(slope.facing * along_y + slope.across * along_x);
  const auto [slope_x, slope_y] = slopes.slope(u, w);
  return normalized({-slope_x, -slope_y, 1});
}

} // namespace brdfplot
