/// \file
/// Karis's approximation of Smith's masking function.
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>

namespace brdfplot {

/// G1 = 2 c / (c (2 - alpha) + alpha) (RTR 9.44), so Lambda = alpha (1 - c) / (2 c): made for GGX, of which it is off
/// by up to 0.164 (for small alpha, where c = 1.149 alpha), and used with any distribution at its roughness, alpha_o
/// towards the direction where it is anisotropic, the width of its slopes where alpha is another thing (velvet, sheen).
/// Any alpha; the print is for alpha <= 1.
struct Karis {
  static ModelSpec spec() {
    return {.type = "karis",
            .doc = "G1 = 2 NV / (NV (2 - alpha) + alpha): off by up to 0.164 for GGX",
            .source = "Karis 2013; Akenine-Moller et al. 2018, Eq. 9.44"};
  }
  static Karis from(const Values&) { return {}; }
  static constexpr bool has_lambda = true;
  static constexpr bool is_of_several_a = true;

  /// With the cosine c / n after the vertical shear that levels the mesosurface, n^2 = h^2 + c^2 with h^2 = x^2 + y^2,
  /// c Lambda = alpha_o (n - c) / 2, where alpha_o = s / h and n - c = h^2 / (n + c).
  static double masked_area(const Projection& p, const Direction& omega) {
    const double h = std::hypot(omega.x, omega.y);
    return 0.5 * p.s * (h / (std::hypot(h, p.c) + p.c));
  }
};

} // namespace brdfplot
