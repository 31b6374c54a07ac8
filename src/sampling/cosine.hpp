/// \file
/// Lambert's lobe.
#pragma once

#include "math/direction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdfplot {

/// A direction with the density cos / pi about the unit vector n, n.z > 0, of two numbers in [0, 1): even on the disc
/// (Malley). The disc's axes are those of Duff et al. (2017), which turn smoothly with n.
inline Direction sample_cosine(const Direction& n, double u1, double u2) {
  const double r = std::sqrt(u1);
  const double phi = 2 * std::numbers::pi * u2;
  const double x = r * std::cos(phi), y = r * std::sin(phi), z = std::sqrt(1 - u1);
  const double a = -1 / (1 + n.z), b = n.x * n.y * a;
  const Direction t{1 + n.x * n.x * a, b, -n.x}, s{b, 1 + n.y * n.y * a, -n.y};
  return normalized(x * t + y * s + z * n);
}

} // namespace brdfplot
