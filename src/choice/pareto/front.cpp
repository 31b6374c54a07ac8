#include "choice/pareto/front.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

Dominated dominated(std::span<const CostError> points, double slack) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::isfinite(points[k].cost) && std::isfinite(points[k].error)) order.push_back(k);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const CostError &p = points[a], &q = points[b];
    return p.cost < q.cost || (!(q.cost < p.cost) && p.error < q.error);
  });
  Dominated result{std::vector<bool>(points.size()), std::vector<std::optional<std::size_t>>(points.size())};
  std::optional<std::size_t> best; // of all that cost no more, with the slack
  std::size_t reached = 0;
  for (const std::size_t k : order) {
    for (; reached < order.size() && points[order[reached]].cost <= slack * points[k].cost; ++reached)
      if (!best || points[order[reached]].error < points[*best].error) best = order[reached];
    result.on_front[k] = best == k;
    if (best != k) result.by[k] = best;
  }
  return result;
}

} // namespace brdfplot::choice
