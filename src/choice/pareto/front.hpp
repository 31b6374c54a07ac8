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

/// By how much costs and errors have to differ to be told apart, as factors.
struct Slack {
  double cost = 1, error = 1;
};

/// Which points are on the front, and who dominates the others: a point on the front that costs no more and errs no
/// more, within the slack.
struct Dominated {
  std::vector<bool> on_front;
  std::vector<std::optional<std::size_t>> by; ///< none of a point that is on the front or is none
};

/// The Pareto front, from the cheapest on: the next point is the cheapest whose error is smaller by more than the slack
/// than that of the last one or, of those that cost as much within the slack, the one with the least error. Without
/// slack these are all to which no other is equal in both or better in one and as good in the other; of equal ones, the
/// first. With slack they are some of these.
Dominated dominated(std::span<const CostError> points, const Slack& slack = {});

} // namespace brdfplot::choice
