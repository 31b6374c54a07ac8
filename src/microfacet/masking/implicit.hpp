/// \file
/// The implicit masking function (Heitz 2014, Eqs. 55-57).
#pragma once

#include "microfacet/slopes.hpp"

namespace brdfplot {

/// G1 = c: what is assumed when G2 / (cos theta_o cos theta_i) is left out of the BRDF.
struct Implicit {
  static ModelSpec spec() {
    return {.type = "implicit",
            .doc = "cancels the denominator of the BRDF; not physically based",
            .source = "McAuley et al. 2013; Heitz 2014, Eqs. 55-57"};
  }
  static Implicit from(const Values&) { return {}; }
  static constexpr bool has_lambda = false;

  /// c / G1.
  double unmasked_area(const Projection&, double, double) const { return 1; }
};

} // namespace brdfplot
