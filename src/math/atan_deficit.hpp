/// \file
/// A difference with the arc tangent that every integral of Smith's masking in polar slopes contains.
#pragma once

#include <cmath>

namespace brdfplot {

/// 1 - atan(s) / s, by its series where the difference cancels: s^2 (1/3 - s^2 / 5 + s^4 / 7 - ...) up to s = 0.35,
/// where the first term left out is below 1e-17 of the sum. Domain s >= 0, infinity included (1); relative error below
/// 4e-15.
inline double atan_deficit(double s) {
  if (s > 0.35) return 1 - std::atan(s) / s;
  const double s2 = s * s;
  double power = 1;
  double sum = 0;
  for (int k = 3; k <= 37; k += 2) {
    sum += power / k;
    power *= -s2;
  }
  return s2 * sum;
}

} // namespace brdfplot
