/// \file
/// Schlick's version of Smith's function, and his rational approximation of it (Heitz 2014, section 4.3).
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>
#include <numbers>

namespace brdfplot {

inline constexpr double sqrt_pi = 1 / std::numbers::inv_sqrtpi;

/// Schlick 1994, Eq. 18: G1 = g / (g + 1), g = sqrt(pi h) (2 - erfc sqrt h), h = v^2 / (2 m^2 (1 - v^2)), with m the
/// root mean square slope per axis, so h = a^2. Not Smith's function: the exponential of its denominator is missing
/// (Heitz 2014, section 4.3).
struct SchlickSmith {
  static ModelSpec spec() {
    return {.type = "schlick_smith",
            .doc = "Schlick's Eq. 18, with m the rms slope alpha / sqrt(2) throughout",
            .source = "Schlick 1994, Eq. 18; Heitz 2014, section 4.3"};
  }
  static SchlickSmith from(const Values&) { return {}; }
  static constexpr bool has_lambda = true;

  /// Lambda = 1 / g, so c Lambda = s / (sqrt(pi) (1 + erf a)).
  double masked_area(const Projection& p, const Direction&) const {
    return p.s > 0 ? p.s / (sqrt_pi * (1 + std::erf(p.c / p.s))) : 0;
  }
};

/// Schlick 1994, Eq. 20: G1 = v / (v - k v + k), k = sqrt(2 m^2 / pi) = alpha_o / sqrt(pi), with the same m as in
/// Eq. 18 (Heitz 2014, section 4.3, on the two meanings of m in the paper).
struct SchlickSmithRational {
  static ModelSpec spec() {
    return {.type = "schlick_smith_rational",
            .doc = "Schlick's Eq. 20, with m the rms slope alpha / sqrt(2) throughout",
            .source = "Schlick 1994, Eq. 20; Heitz 2014, section 4.3"};
  }
  static SchlickSmithRational from(const Values&) { return {}; }
  static constexpr bool has_lambda = true;
  static constexpr bool is_of_several_a = true;

  /// v is the cosine after the vertical shear that levels the mesosurface, c / n with n^2 = x^2 + y^2 + c^2. Then
  /// c Lambda = k (n - c) with k = s / (sqrt(pi) h), h^2 = x^2 + y^2, and n - c = h^2 / (n + c).
  double masked_area(const Projection& p, const Direction& omega) const {
    const double h = std::hypot(omega.x, omega.y);
    return p.s * h / (sqrt_pi * (std::hypot(h, p.c) + p.c));
  }
};

} // namespace brdfplot
