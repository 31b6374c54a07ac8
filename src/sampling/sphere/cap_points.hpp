/// \file
/// Directions within a spherical cap, for integrals over light of a sphere or a disc.
#pragma once

#include "math/direction.hpp"

#include <cstddef>
#include <vector>

namespace brdfplot::sphere {

/// A direction towards a light, in the frame of the picture, and the solid angle that it stands for.
struct LightPoint {
  Direction direction;
  double weight;
};

/// rings x 4 rings directions within `radius` of the direction (theta, phi): Gauss-Legendre nodes in the cosine of the
/// angle from it, evenly spaced azimuths. The weights sum up to 4 pi sin^2(radius / 2). `rings` is 1 or even.
std::vector<LightPoint> cap_points(double theta, double phi, double radius, std::size_t rings);

} // namespace brdfplot::sphere
