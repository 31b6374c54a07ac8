#include "choice/pareto/front.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::choice {

Dominated dominated(std::span<const CostError> points, const Slack& slack) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::isfinite(points[k].cost) && std::isfinite(points[k].error)) order.push_back(k);
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const CostError &p = points[a], &q = points[b];
    return p.cost < q.cost || (!(q.cost < p.cost) && p.error < q.error);
  });
  Dominated result{std::vector<bool>(points.size()), std::vector<std::optional<std::size_t>>(points.size())};
  std::optional<std::size_t> last; // on the front
  for (std::size_t first = 0; first < order.size(); ++first) {
    const CostError& cheapest = points[order[first]];
    if (last && !(cheapest.error * slack.error < points[*last].error)) {
      result.by[order[first]] = last;
      continue;
    }
    std::size_t best = order[first];
    for (std::size_t k = first; k < order.size() && points[order[k]].cost <= slack.cost * cheapest.cost; ++k)
      if (points[order[k]].error < points[best].error) best = order[k];
    result.on_front[best] = true;
    last = best;
    if (best != order[first]) result.by[order[first]] = best;
  }
  for (std::size_t k = 0; k < points.size(); ++k)
    if (result.on_front[k]) result.by[k].reset();
  return result;
}

} // namespace brdfplot::choice
