#include "simulation/tally.hpp"

#include <cmath>

namespace brdfplot::simulation {

void Tally::add_tiles(std::size_t count) {
  done_.resize(done_.size() + count, 0);
  sums_.resize(done_.size() * 2 * width_, 0.0);
}

std::span<double> Tally::half(std::size_t tile, std::size_t which) {
  return {sums_.data() + (2 * tile + which) * width_, width_};
}

std::span<const double> Tally::half(std::size_t tile, std::size_t which) const {
  return {sums_.data() + (2 * tile + which) * width_, width_};
}

std::vector<double> Tally::total(const std::vector<std::size_t>& columns) const {
  std::vector<double> sum(columns.size(), 0.0);
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    if (done_[tile] == 0) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) sum[k] += half(tile, 0)[columns[k]] + half(tile, 1)[columns[k]];
  }
  return sum;
}

Measured Tally::estimate(const std::vector<std::size_t>& columns, const Function& f) const {
  const std::vector<double> all = total(columns);
  std::vector<double> left_out;
  std::vector<double> without(columns.size());
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    if (done_[tile] == 0) continue;
    for (std::size_t k = 0; k < columns.size(); ++k)
      without[k] = all[k] - half(tile, 0)[columns[k]] - half(tile, 1)[columns[k]];
    left_out.push_back(f(without));
  }
  // (n - 1) / n sum of squares: the error of the mean times n - 1.
  const Measured mean = mean_of(left_out);
  return {f(all), mean.standard_error * static_cast<double>(left_out.size() - 1)};
}

Measured Tally::estimate_of_this_surface(const std::vector<std::size_t>& columns, const Function& f) const {
  const std::vector<double> all = total(columns);
  double variance = 0;
  std::vector<double> up(columns.size()), down(columns.size());
  for (std::size_t tile = 0; tile < tiles(); ++tile) {
    if (done_[tile] == 0) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double difference = half(tile, 0)[columns[k]] - half(tile, 1)[columns[k]];
      up[k] = all[k] + difference;
      down[k] = all[k] - difference;
    }
    const double change = (f(up) - f(down)) / 2;
    variance += change * change;
  }
  return {f(all), std::sqrt(variance)};
}

} // namespace brdfplot::simulation
