#include "simulation/measures/tally.hpp"

#include <algorithm>
#include <cmath>

namespace brdfplot::simulation {

void Tally::begin_realisation(std::size_t tiles) {
  first_ = done_.size();
  done_.resize(first_ + tiles, 0);
  sums_.resize(done_.size() * 2 * width_, 0.0);
}

std::span<double> Tally::half(std::size_t tile, std::size_t which) {
  return {sums_.data() + (2 * (first_ + tile) + which) * width_, width_};
}

std::span<const double> Tally::row(std::size_t tile, std::size_t which) const {
  return {sums_.data() + (2 * tile + which) * width_, width_};
}

void Tally::end_realisation() {
  std::vector<double> sums(width_, 0.0);
  for (std::size_t tile = first_; tile < done_.size(); ++tile)
    for (std::size_t k = 0; k < width_ && done_[tile] != 0; ++k) sums[k] += row(tile, 0)[k] + row(tile, 1)[k];
  if (std::find(done_.begin() + static_cast<std::ptrdiff_t>(first_), done_.end(), char{1}) != done_.end())
    realisations_.insert(realisations_.end(), sums.begin(), sums.end());
  if (keep_tiles_) return;
  done_.clear();
  sums_.clear();
}

std::vector<double> Tally::total(const std::vector<std::size_t>& columns) const {
  std::vector<double> sum(columns.size(), 0.0);
  for (std::size_t first = 0; first < realisations_.size(); first += width_)
    for (std::size_t k = 0; k < columns.size(); ++k) sum[k] += realisations_[first + columns[k]];
  return sum;
}

Measured Tally::estimate(const std::vector<std::size_t>& columns, const Function& f) const {
  if (drawn_ == Drawn::rays) return estimate_of_rays(columns, f);
  const std::vector<double> all = total(columns);
  std::vector<double> left_out;
  std::vector<double> without(columns.size());
  for (std::size_t first = 0; first < realisations_.size(); first += width_) {
    for (std::size_t k = 0; k < columns.size(); ++k) without[k] = all[k] - realisations_[first + columns[k]];
    left_out.push_back(f(without));
  }
  // (n - 1) / n sum of squares: the error of the mean times n - 1. A NaN: one realisation has all there is.
  const double error = mean_of(left_out).standard_error * static_cast<double>(left_out.size() - 1);
  return {f(all), std::isnan(error) ? INFINITY : error};
}

Measured Tally::estimate_of_rays(const std::vector<std::size_t>& columns, const Function& f) const {
  const std::vector<double> all = total(columns);
  double variance = 0;
  std::vector<double> up(columns.size()), down(columns.size());
  for (std::size_t tile = 0; tile < done_.size(); ++tile) {
    if (done_[tile] == 0) continue;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const double difference = row(tile, 0)[columns[k]] - row(tile, 1)[columns[k]];
      up[k] = all[k] + difference;
      down[k] = all[k] - difference;
    }
    const double change = (f(up) - f(down)) / 2;
    variance += change * change;
  }
  return {f(all), std::sqrt(variance)};
}

} // namespace brdfplot::simulation
