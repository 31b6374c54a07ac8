/// \file
/// The inputs at which the methods of a problem are compared, with their exact values.
#pragma once

#include "choice/methods/method.hpp"

namespace brdfplot::choice {

/// Inputs in columns and, of each row, the exact value at the inputs as the format holds them.
struct Samples {
  bool single = false;                     ///< the inputs are floats
  std::size_t grid = 0;                    ///< how many of the rows, the first, lie even in the scales of the inputs
  std::vector<std::vector<double>> inputs; ///< [input][row]
  std::vector<Exact> exact;

  std::size_t size() const { return exact.size(); }
  std::vector<double> row(std::size_t index) const;
};

/// Half of problem.samples on a grid over the whole domain, both ends included; half at random bit patterns between
/// those ends, which are even in the logarithm, with a seed of their own: the same always. On up to `threads` threads.
Samples sample(const Problem& problem, bool single, int threads);

/// An input of a place in [0, 1], even in its scale: `low` at 0, `high` at 1.
double at_place(const Input& input, double place);
/// The place of a value.
double place_of(const Input& input, double value);

} // namespace brdfplot::choice
