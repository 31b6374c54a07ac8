/// \file
/// Means with their standard errors, from independent chunks of a simulation.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>

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

} // namespace brdfplot::simulation
