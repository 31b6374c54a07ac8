/// \file
/// V-cavities (Heitz 2014, section 4.2).
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>

namespace brdfplot {

/// G1 = min(1, 2 (m.g) c / (o.m)) (Eq. 49), c the projected area of the mesosurface.
struct VCavity {
  static ModelSpec spec() {
    return {.type = "v_cavity",
            .doc = "one ridged surface per pair of normals; exact for it",
            .source = "Torrance and Sparrow 1967; Cook and Torrance 1982; Heitz 2014, Eq. 49"};
  }
  static VCavity from(const Values&) { return {}; }
  static constexpr bool has_lambda = false;
  static constexpr bool kink_is_line = true;
  static constexpr const char* default_shadowing = "minimum";
  static constexpr const char* exact_for_surface = "v_cavity";

  /// c / G1, without the division of c by a vanishing o.m. Domain o.m > 0, z_m > 0.
  double unmasked_area(const Projection& p, double o_dot_m, double z_m) const {
    return std::fmax(p.c, 0.5 * o_dot_m / z_m);
  }
  /// Changes its sign where the other normal begins to be seen (see masking.hpp).
  static double kink(const Projection& p, double o_dot_m, double z_m) { return 2 * z_m * p.c - o_dot_m; }
};

} // namespace brdfplot
