/// \file
/// Several means over what is reflected, of one pass over the light.
#pragma once

#include "brdf/integrals/reflected_light.hpp"

#include <vector>

namespace brdfplot {

/// As reflected_light() of one channel, for up to three weights: that of weights[k] at [k]. What is about the half
/// vector is evaluated once for all of them.
ColourEstimate reflected_moments(const std::vector<const WeightedTerm*>& terms, const Direction& omega_o,
                                 double tolerance, std::size_t channel, const std::vector<LightWeight>& weights);

} // namespace brdfplot
