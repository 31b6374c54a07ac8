/// \file
/// Which methods nothing else is better than.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace brdfplot::choice {

/// A point, cost and error, smaller is better. What is not known, infinite or NaN is on no front.
struct CostError {
  double cost = 0;
  double error = 0;
};

/// Whether a point is on the Pareto front: no other is as good in both and better in one. Else who dominates it: of the
/// points on the front that cost no more, the one with the least error. Of equal points the first is on the front, and
/// dominates the others.
struct Dominated {
  std::vector<bool> on_front;
  std::vector<std::optional<std::size_t>> by; ///< none of a point that is on the front or is none
};

Dominated dominated(std::span<const CostError> points);

} // namespace brdfplot::choice
