/// \file
/// Means of the Fresnel term of a material.
#pragma once

#include "brdf/material.hpp"
#include "math/quadrature.hpp"

#include <cstddef>

namespace brdfplot {

/// int F(o.m) D_o(m) dm of one channel, the reflectance of the facets that the viewer sees, weighted by how much of
/// each it sees (Heitz 2014, Eq. 105). Domain c_o > 0; the error bounds the true one.
Estimate mean_visible_reflectance(const WeightedTerm& term, const Direction& omega_o, double tolerance,
                                  std::size_t channel);

} // namespace brdfplot
