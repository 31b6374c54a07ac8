/// \file
/// Smith's microsurface for rays in every direction, those that fall included.
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>

namespace brdfplot::simulation {

/// A distribution of slopes, its Shape stretched by `slopes` (see shape_invariant.hpp), with what a ray needs of it.
template <class Shape>
struct SmithProfile {
  SlopeMap slopes;

  /// Lambda of every direction: of one above the mesosurface Eqs. 69 and 72 of Heitz 2014; below, -1 - Lambda(-omega)
  /// (Heitz et al. 2016); infinity along the mesosurface.
  double Lambda(const Direction& omega) const {
    const Projection p = slopes.project(omega);
    const double ratio = masked(p) / std::fabs(p.c);
    return p.c > 0 ? ratio : p.c < 0 ? -1 - ratio : infinity;
  }

  /// Projected area of the facets that face v, int <v, m> D(m) dm: c (1 + Lambda(v)), finite everywhere.
  double sigma(const Direction& v) const {
    const Projection p = slopes.project(v);
    return masked(p) + std::fmax(p.c, 0.0);
  }

  /// D(m) of a normal above the horizon.
  double density(const Direction& m) const {
    return Shape::scaled_density(slopes.scaled_norm2(m), m.z * m.z) / slopes.determinant();
  }

private:
  /// |c| Lambda of the direction or its opposite, whichever is above the mesosurface.
  double masked(const Projection& p) const { return p.s > 0 ? p.s * Shape::a_lambda(std::fabs(p.c) / p.s) : 0; }
};

} // namespace brdfplot::simulation
