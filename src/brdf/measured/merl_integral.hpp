/// \file
/// Integrals over the light of what is constant in cells of half and difference angles.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/measured/merl_table.hpp"
#include "math/quadrature.hpp"

#include <functional>

namespace brdfplot {

/// int rho(o, i) c_i w(i) di over the light, for a smooth w. Over the half vectors: along each circle of theta_h the
/// places are known at which theta_d or phi_d passes into the next cell, or the light below the horizon, and between
/// them Gauss's rule has nothing but a trigonometric polynomial and w before it. What is left to do is an adaptive
/// integral over theta_h, cut at the edges of cells; where two of the other edges cross it has a kink, so that it
/// converges slowly from about 1e-6 on, and says so. Domain c_o > 0; `tolerance` is absolute.
ColourEstimate integrate_merl(const MerlTable& table, const Direction& omega_o, double tolerance,
                              const ChannelRange& channels,
                              const std::function<double(const Direction& omega_i)>& weight);

} // namespace brdfplot
