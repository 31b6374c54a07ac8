/// \file
/// Where the lobe of reflected light is highest in the plane of incidence.
#pragma once

#include "brdf/material.hpp"
#include "brdf/quantity.hpp"
#include "math/direction.hpp"
#include "math/quadrature.hpp"

namespace brdfplot {

/// The horizontal unit vector along omega_o's azimuth (x where it has none).
Direction azimuth(const Direction& omega_o);

/// The largest value of `quantity`, brdf or brdf_cos, in the plane of incidence: the best of a scan that is dense
/// around the mirror direction, then golden section. On a smooth top that finds no more than half of the digits, since
/// the values are flat there, and the zero of the derivative is taken; where that is lower the top is a kink, and
/// golden section was exact. theta_i in radians, signed: negative on the side of the mirror direction. `width`: the
/// smallest of the distribution, in slopes; the derivative is taken over a part of it. `channel`: of a coloured
/// material.
Estimate peak_theta_i(const Material& material, Quantity quantity, const Direction& omega_o, double width, int channel);

} // namespace brdfplot
