/// \file
/// What terms of a BRDF reflect of light from one direction: integrals over the other one.
#pragma once

#include "brdf/integrals/kinks.hpp"
#include "brdf/material.hpp"
#include "math/quadrature.hpp"

#include <functional>
#include <vector>

namespace brdfplot {

/// What light from omega_i counts.
using LightWeight = std::function<double(const Direction& omega_i)>;

/// int rho(o, i) c_i w(i) di of a term without its weight, for a range of its channels: channel `first` at [0]. Over
/// the half vectors where the term is about_half_vector, else over the hemisphere of the light. `tolerance` is
/// absolute; the errors bound the true ones. Domain c_o > 0.
ColourEstimate reflected_light(const BrdfTerm& term, const Direction& omega_o, double tolerance,
                               const ChannelRange& channels, const LightWeight& weight);

/// The sum over the terms, with their weights. A term of one channel is integrated once.
ColourEstimate reflected_light(const std::vector<const WeightedTerm*>& terms, const Direction& omega_o,
                               double tolerance, const ChannelRange& channels, const LightWeight& weight);

/// Whether a term brings a rule of its own: it is measured, and its integrals are known less closely than those of a
/// formula.
bool is_measured(const BrdfTerm& term);

/// The weight of an albedo: 1.
inline double every_direction(const Direction&) { return 1; }

} // namespace brdfplot
