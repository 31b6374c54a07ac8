/// \file
/// Every float: an upper bound where searches give a lower one.
#pragma once

#include "choice/methods/method.hpp"

#include <cstdint>

namespace brdfplot::choice {

/// The worst of a method in float over all floats of its domain.
struct Exhausted {
  std::string problem, method;
  std::string against;          ///< the method in double whose values count as exact
  std::uint64_t inputs = 0;     ///< so many floats there are
  double error = 0;             ///< the largest relative error of what is seen; what is below 2^-63 counts as that
  float at = 0;                 ///< where it is
  std::uint64_t not_finite = 0; ///< so many of the values are none
};

/// The methods in float of a problem with one input, each against the kernel in double, or, where there is none, the
/// first rewritten formula. That one's own error, some 1e-15, is not seen beside a float's. None of other problems.
/// \throws Interrupted
std::vector<Exhausted> exhaust(const Problem& problem, const std::string& only, int threads,
                               const std::function<void(double share)>& progress);

/// A table for a page.
std::string exhausted_markdown(const std::vector<Exhausted>& all);

} // namespace brdfplot::choice
