/// \file
/// A masking function that the user writes: what a shader computes, to be held against Table 3.
#pragma once

#include "math/formula.hpp"
#include "microfacet/slopes.hpp"

#include <optional>

namespace brdfplot {

/// G1 = 1 / (1 + Lambda) with `lambda` a formula of the masked direction, or G1 a formula of it and of the normal.
/// Facets that face away, and directions below the mesosurface, are masked whatever the formula says.
struct CustomMasking {
  std::optional<Formula> lambda, g1; ///< one of them
  bool has_lambda = false;           ///< which
  static constexpr bool is_formula = true;

  static ModelSpec spec();
  static CustomMasking from(const Values& values);

  /// c Lambda; with a formula of Lambda. Domain c > 0.
  /// \throws InputError where the formula is not a number, as `lambda` of 0 * infinity is.
  double masked_area(const SlopeMap& map, const Projection& p, const Direction& omega) const;
  /// c / G1; with a formula of G1. `o_dot_m`: omega.m, which near grazing has digits that a half vector omega_m has
  /// lost. Domain c > 0, omega.m > 0, z_m > 0. \throws InputError as masked_area().
  double unmasked_area(const SlopeMap& map, const Projection& p, const Direction& omega, const Direction& omega_m,
                       double o_dot_m) const;
};

} // namespace brdfplot
