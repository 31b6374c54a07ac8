/// \file
/// The slopes that a surface has, beside those that were asked.
#pragma once

#include "simulation/surface.hpp"
#include "simulation/tiles.hpp"

#include <limits>
#include <span>

namespace brdfplot::simulation {

/// Statistics of the facets of one realisation, each weighted with the area that it covers seen from above.
struct SlopeStatistics {
  /// Roughnesses, correlation and mean. For GGX, whose slopes have no variance, from medians: half of the slopes along
  /// an axis lie within alpha / sqrt(3) of the mean. Else from second moments: alpha^2 is twice the variance.
  SlopeMap slopes;
  /// This and the following are NaN where all slopes are along one line.
  /// Half the sum of |share - probability| over 16 by 8 bins of equal probability, in radius and azimuth of the unit
  /// slope: the total variation between histogram and P22 as far as the bins resolve it. Without slopes asked: from a
  /// Beckmann distribution of the measured ones.
  double distance = std::numeric_limits<double>::quiet_NaN();
  /// What the distance of a sample of `independent` slopes from their own distribution would be on average.
  double expected_distance = std::numeric_limits<double>::quiet_NaN();
  /// Pearson's chi^2 of the bins, as if `independent` slopes had been drawn; 127 degrees of freedom.
  double chi2 = std::numeric_limits<double>::quiet_NaN();
  /// How many independent slopes scatter as much as these do between the tiles.
  double independent = std::numeric_limits<double>::quiet_NaN();

  static constexpr int degrees_of_freedom = 127;
};

SlopeStatistics measure_slopes(const Surface& surface, std::span<const Tile> tiles);

} // namespace brdfplot::simulation
