/// \file
/// Linear light as a screen has it.
#pragma once

#include <algorithm>
#include <cmath>

namespace brdfplot::plot {

/// The value of sRGB for a linear one (IEC 61966-2-1:1999, section 5.2): 12.92 c up to 0.0031308, then
/// 1.055 c^(1/2.4) - 0.055; 0 where c < 0. Not cut at 1.
inline double srgb(double linear) {
  if (linear <= 0.0031308) return 12.92 * std::fmax(linear, 0.0);
  return 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// The same as a byte, cut at white and rounded to the nearest.
inline unsigned char srgb_byte(double linear) {
  return static_cast<unsigned char>(std::lround(255 * std::min(srgb(linear), 1.0)));
}

/// The linear difference that is one step of a byte where the curve is steepest: at black.
inline constexpr double finest_step = 1 / (255 * 12.92);

} // namespace brdfplot::plot
