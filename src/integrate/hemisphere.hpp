/// \file
/// Integration over the directions of the light, for BRDFs that have no half vector to follow.
#pragma once

#include "math/quadrature.hpp"
#include "microfacet/slopes.hpp"

#include <functional>

namespace brdfplot {

/// rho(o, i) with its error, to a tolerance.
using PairFunction = std::function<Estimate(const Direction& omega_i, const Tolerance& tolerance)>;

/// int rho(o, i) c_i w(i) di over the directions above the mesosurface, whose slopes are those of `map`, where rho is
/// smooth on the scale of the hemisphere: facets that are not mirrors. Polar angles about the mean normal, cut where
/// BRDFs of rough surfaces have a kink: at i = o, and where the azimuths of o and i are equal, at right angles or
/// opposite. `symmetric`: the mirror image at the plane of incidence changes nothing. The error of rho itself is part
/// of the estimate.
Estimate integrate_hemisphere(const SlopeMap& map, bool symmetric, const PairFunction& rho, const Direction& omega_o,
                              double tolerance, const std::function<double(const Direction& omega_i)>& weight);

} // namespace brdfplot
