/// \file
/// Kelemen's masking function (Heitz 2014, Eqs. 58-60).
#pragma once

#include "microfacet/slopes.hpp"

namespace brdfplot {

/// G1 = c / (o.m) (Eq. 59). As printed it is above 1 where o.m < c.
struct Kelemen {
  static ModelSpec spec() {
    return {.type = "kelemen",
            .doc = "G2 / (cos theta_o cos theta_i) = 1 / (o.h)^2; not physically based",
            .source = "Kelemen and Szirmay-Kalos 2001, Eq. 2; Heitz 2014, Eqs. 58-60"};
  }
  static Kelemen from(const Values&) { return {}; }
  static constexpr bool has_lambda = false;

  /// c / G1. Domain o.m > 0.
  double unmasked_area(const Projection&, double o_dot_m, double) const { return o_dot_m; }
};

} // namespace brdfplot
