/// \file
/// Integration over the directions of the light, for BRDFs that have no half vector to follow.
#pragma once

#include "math/direction.hpp"
#include "math/quadrature.hpp"
#include "microfacet/slopes.hpp"

#include <functional>
#include <vector>

namespace brdfplot {

/// What is known of rho at a fixed viewer, as a function of the light.
struct HemisphereIntegrand {
  /// Writes rho of channel c at light k, to the tolerance, to value[c n + k], and what is known of its error.
  std::function<void(const std::vector<Direction>& omega_i, const Tolerance& tolerance, std::vector<double>& value,
                     std::vector<double>& error)>
      rho;
  std::size_t channels = 1;
  bool symmetric = false;      ///< the mirror image at the plane of incidence changes nothing
  bool times_cosine = false;   ///< rho c_i instead of rho
  std::vector<double> bends{}; ///< cosines of i with the mean normal where rho bends, but 1; light reaches down to the
                               ///< lowest one, or to the horizon where there are none
};

/// int rho(o, i) c_i w(i) di of each channel over the directions that light comes from, above a mesosurface whose
/// slopes are those of `map`, where rho is smooth on the scale of the hemisphere: facets that are not mirrors. Polar
/// angles about the mean normal, cut where BRDFs of rough surfaces have a kink: at i = o, and where the azimuths of o
/// and i are equal, at right angles or opposite. The error of rho itself is part of the estimate.
ColourEstimate integrate_hemisphere(const SlopeMap& map, const HemisphereIntegrand& f, const Direction& omega_o,
                                    double tolerance, const std::function<double(const Direction& omega_i)>& weight);

} // namespace brdfplot
