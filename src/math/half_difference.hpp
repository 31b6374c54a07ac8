/// \file
/// A pair of directions as its half vector and the difference from it (Rusinkiewicz 1998).
#pragma once

#include "math/direction.hpp"

#include <cmath>

namespace brdfplot {

/// theta_h, phi_h: the half vector. theta_d, phi_d: omega_i in the frame of the half vector h, whose x axis is that of
/// growing theta_h and whose y axis is horizontal. phi_d is 0 or pi where o, i and the normal lie in one plane;
/// exchanging o and i adds pi to it.
struct HalfDifference {
  double theta_h = 0, phi_h = 0, theta_d = 0, phi_d = 0;
};

struct ViewerAndLight {
  Direction o, i;
};

/// The pair of these angles: i = sin theta_d (cos phi_d x + sin phi_d y) + cos theta_d h, o the same with the other
/// sign of the first. Either may be below the horizon.
inline ViewerAndLight pair_of(const HalfDifference& at) {
  const Direction h = from_angles(at.theta_h, at.phi_h);
  const Direction x = {std::cos(at.theta_h) * std::cos(at.phi_h), std::cos(at.theta_h) * std::sin(at.phi_h),
                       -std::sin(at.theta_h)};
  const Direction y = {-std::sin(at.phi_h), std::cos(at.phi_h), 0};
  const Direction across = std::sin(at.theta_d) * (std::cos(at.phi_d) * x + std::sin(at.phi_d) * y);
  const Direction along = std::cos(at.theta_d) * h;
  return {along + -1.0 * across, along + across};
}

/// The angles of a pair, which has a half vector. theta_h and theta_d in [0, pi/2] where both are above the horizon;
/// phi_h and phi_d in [-pi, pi]. Sines below 1e-15, which is how well unit vectors are known, count as 0: where the
/// half vector is the normal, phi_h is the azimuth of i and phi_d = 0; a pair in one plane with it has phi_d = 0 or pi.
inline HalfDifference half_difference(const Direction& o, const Direction& i) {
  constexpr double rounding = 1e-15;
  const Direction sum = o + i, difference = i + -1.0 * o;
  const double length = std::sqrt(dot(sum, sum)), across = std::sqrt(dot(difference, difference));
  const double horizontal = std::hypot(sum.x, sum.y);
  const double theta_d = std::atan2(across, length);
  if (!(horizontal > rounding * length)) return {0, std::atan2(difference.y, difference.x), theta_d, 0};
  const double c = sum.x / horizontal, s = sum.y / horizontal; // cos phi_h, sin phi_h
  const double cos_h = sum.z / length, sin_h = horizontal / length;
  const double x = cos_h * (c * difference.x + s * difference.y) - sin_h * difference.z;
  const double y = c * difference.y - s * difference.x;
  return {std::atan2(horizontal, sum.z), std::atan2(sum.y, sum.x), theta_d,
          std::atan2(std::fabs(y) > rounding ? y : 0, x)};
}

} // namespace brdfplot
