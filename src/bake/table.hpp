/// \file
/// Tables as a renderer reads them.
#pragma once

#include "bake/axis.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace brdfplot::bake {

/// Values on a grid of nodes, between which they are interpolated linearly in each axis's share.
struct Table {
  std::string material, quantity;
  std::vector<Axis> axes;            ///< the first one varies fastest
  std::vector<std::string> channels; ///< the values of a node, side by side
  std::vector<double> values;

  std::size_t nodes() const; ///< how many nodes there are
  /// The values at shares of the way along each axis, in [0, 1]: multilinear, as a texture that is clamped.
  std::vector<double> interpolated(const std::vector<double>& shares) const;
};

/// A table and what is known of its error.
struct BakedTable {
  Table table;
  double tolerance = 0;           ///< of each value
  std::vector<double> axis_error; ///< the largest error half-way between two nodes of an axis, those of the others kept
  std::vector<double> where;      ///< of the largest of these, the values of the axes
  /// What the interpolation is off by at most: I - I_1 ... I_d is a sum of what each axis leaves, so 1.5 times the sum
  /// of axis_error, since half-way is where a smooth function is off most but a kink is not, and the tolerance.
  double bound = 0;
};

} // namespace brdfplot::bake
