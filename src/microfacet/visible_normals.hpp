/// \file
/// Random normals as they are seen from a direction: samples of D_v(m) = <v, m> D(m) / sigma(v) (Heitz 2014, Eq. 16),
/// from above and, for the rays of a random walk, from below the horizon too.
#pragma once

#include "base/random.hpp"
#include "math/direction.hpp"
#include "microfacet/slopes.hpp"
#include "microfacet/visible_slopes.hpp"

#include <cmath>
#include <concepts>

namespace brdfplot {

/// Whether a shape can sample its visible slopes: `sample_visible_slope(c, s, random)`, seen from the unit vector of
/// cosine c and sine s >= 0 in the space of unit roughness.
template <class Shape>
concept SamplesVisibleSlopes = requires(double c, double s, Random& random) {
  { Shape::sample_visible_slope(c, s, random) } -> std::same_as<UnitSlope>;
};

/// Whether a distribution is such a shape, stretched.
template <class D>
concept SamplesVisibleNormals = requires {
  requires SamplesVisibleSlopes<typename D::UnitShape>;
};

/// Whether a shape has its visible slopes as a function of two numbers in [0, 1): `visible_slope(c, s, u1, u2)`.
template <class Shape>
concept InvertsVisibleSlopes = requires(double c, double s) {
  { Shape::visible_slope(c, s, 0.5, 0.5) } -> std::same_as<UnitSlope>;
};

/// A normal from the slope that `slope_from(c, s)` gives, seen from v as the unit vector of cosine c and sine s in the
/// space of unit roughness.
template <class Function>
Direction visible_normal(const SlopeMap& slopes, const Direction& v, const Function& slope_from) {
  const auto [x, y] = slopes.on_unit_surface(v);
  const auto [c, s] = slopes.project(v);
  const double norm = std::hypot(s, c);
  const double along_x = s > 0 ? x / s : 1;
  const double along_y = s > 0 ? y / s : 0;
  const UnitSlope slope = slope_from(c / norm, s / norm);
  // The slope of the surface falls where the facet faces v.
  const double u = -(slope.facing * along_x - slope.across * along_y);
  const double w = -(slope.facing * along_y + slope.across * along_x);
  const auto [slope_x, slope_y] = slopes.slope(u, w);
  return normalized({-slope_x, -slope_y, 1});
}

/// A visible normal. v: any direction but (0, 0, -1) in the space of unit roughness, from where no facet is seen.
template <SamplesVisibleSlopes Shape>
Direction sample_visible_normal(const SlopeMap& slopes, const Direction& v, Random& random) {
  return visible_normal(slopes, v, [&](double c, double s) { return Shape::sample_visible_slope(c, s, random); });
}

} // namespace brdfplot
