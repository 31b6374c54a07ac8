#include "choice/pareto/front.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

Dominated dominated(std::span<const CostError> points) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::isfinite(points[k].cost) && std::isfinite(points[k].error)) order.push_back(k);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const CostError &p = points[a], &q = points[b];
    return p.cost < q.cost || (!(q.cost < p.cost) && p.error < q.error);
  });
  Dominated result{std::vector<bool>(points.size()), std::vector<std::optional<std::size_t>>(points.size())};
  std::optional<std::size_t> best;
  for (const std::size_t k : order) {
    if (!best || points[k].error < points[*best].error) {
      result.on_front[k] = true;
      best = k;
    } else {
      result.by[k] = best;
    }
  }
  return result;
}

} // namespace brdfplot::choice
