#include "bake/table.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::bake {

std::size_t Table::nodes() const {
  std::size_t count = 1;
  for (const Axis& axis : axes) count *= axis.nodes;
  return count;
}

std::vector<double> Table::interpolated(const std::vector<double>& shares) const {
  std::vector<double> sum(channels.size(), 0);
  const std::size_t corners = std::size_t{1} << axes.size();
  for (std::size_t corner = 0; corner < corners; ++corner) {
    double weight = 1;
    std::size_t node = 0, stride = 1;
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const auto last = static_cast<double>(axes[k].nodes - 1);
      const double place = std::clamp(shares[k], 0.0, 1.0) * last;
      const double low = std::min(std::floor(place), last - 1), part = place - low;
      const bool upper = (corner >> k & 1) != 0;
      weight *= upper ? part : 1 - part;
      node += stride * (static_cast<std::size_t>(low) + (upper ? 1 : 0));
      stride *= axes[k].nodes;
    }
    if (weight > 0)
      for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += weight * values[node * sum.size() + c];
  }
  return sum;
}

} // namespace brdfplot::bake
