/// \file
/// How far a method is off.
#pragma once

#include "choice/pareto/samples.hpp"

namespace brdfplot::choice {

/// An error and the input of it.
struct Largest {
  double error = 0; ///< with its sign, where it has one; infinite where the method gives none or no number
  std::vector<double> input;
  double value = 0; ///< what the method computes there
  double exact = 0;
};

/// The largest errors that were found: lower bounds of the true largest ones, which a formula in one variable that is
/// smooth comes near to.
struct Errors {
  Largest relative; ///< of the value, where that is no less than the smallest normal number of the format
  Largest ulp;      ///< in units of the last place of the format, of the exact value
  Largest above;    ///< the most that what is seen (Problem::seen; else the value) is above that of the exact value
  Largest below;    ///< the most below, negative
  double relative_rms = 0; ///< over the grid
  double absolute_rms = 0; ///< of what is seen, over the grid

  /// The larger of `above` and `below`.
  const Largest& absolute() const;
};

/// A method over the rows of `inputs`, in columns.
std::vector<double> run(const Method& method, const std::vector<std::vector<double>>& inputs);

/// At all samples and, where an error is large enough to be more than rounding, from the worst of them on by a search
/// for where it is largest.
/// \pre `samples` is of the method's format
Errors errors_of(const Problem& problem, const Method& method, const Samples& samples);

} // namespace brdfplot::choice
