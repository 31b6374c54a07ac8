/// \file
/// Means with their standard errors, from independent chunks of a simulation.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace brdfplot::simulation {

/// A mean, and the standard deviation that it has by itself.
struct Measured {
  double value = 0;
  double standard_error = 0;
};

/// The mean of equally heavy, independent estimates, added in their order. One estimate has an infinite error.
inline Measured mean_of(std::span<const double> estimates) {
  const auto n = static_cast<double>(estimates.size());
  double sum = 0;
  for (const double x : estimates) sum += x;
  const double mean = sum / n;
  double squares = 0;
  for (const double x : estimates) squares += (x - mean) * (x - mean);
  return {mean, n > 1 ? std::sqrt(squares / (n - 1) / n) : INFINITY};
}

/// A quantity at some points, as independent estimates of equal weight.
struct Estimates {
  std::size_t points = 0;
  std::vector<double> values; ///< estimate by estimate, `points` each

  std::size_t count() const { return points > 0 ? values.size() / points : 0; }
  Measured at(std::size_t point) const {
    std::vector<double> here;
    for (std::size_t k = point; k < values.size(); k += points) here.push_back(values[k]);
    return mean_of(here);
  }
  friend bool operator==(const Estimates&, const Estimates&) = default;
};

} // namespace brdfplot::simulation
