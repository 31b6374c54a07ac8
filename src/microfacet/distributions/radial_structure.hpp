/// \file
/// Where a density of slopes that nobody declares is such that a rule of some nodes does not see it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace brdfplot {

/// A density f of the squared slope t2, and samples of it: ascending, so close that no feature is between two of them.
struct RadialSamples {
  std::function<double(double t2)> density;
  std::vector<double> t2s, values;

  double mass_at(std::size_t k) const { return t2s[k] * values[k]; } ///< per unit of ln t2
};

/// Squared slopes, ascending, at which f jumps or has a corner, to rounding: where its second differences do not fall
/// as those of a smooth function do when the interval is halved.
std::vector<double> jumps_and_corners(const RadialSamples& samples);

/// Squared slopes, ascending, between which an integral over the norm sees f: what the samples and the `known` ones
/// span, in x = 6 / (6 + t2), is halved wherever samples are not what the polynomial through 21 nodes has there though
/// its last coefficients say that it has converged. None for densities of one scale; some per octave down to a narrow
/// peak.
std::vector<double> cuts_between_scales(const RadialSamples& samples, const std::vector<double>& known);

} // namespace brdfplot
