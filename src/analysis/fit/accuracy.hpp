/// \file
/// What the code of a fit computes, against the material: with the rounding of the machine that it runs on.
#pragma once

#include "analysis/fit/arithmetic.hpp"

namespace brdfplot {

/// Bounds over the samples, at the arguments as they are given, of what the code computes in one precision.
struct FitAccuracy {
  FitError relative{};  ///< of G1, and where: the error of the fit and `rounding`
  double absolute = 0;  ///< of G1
  double lambda = 0;    ///< relative, of Lambda where that is >= 0.01
  double rounding = 0;  ///< relative, of G1 against the same formula without rounding
  bool in_range = true; ///< n > 0 and m > 0 whatever the rounding, so that G1 is in [0, 1]
};

/// In float where `single`, else in double. Twice the rounding bounds how far G1 of one direction may be below that of
/// a more grazing one.
FitAccuracy accuracy_of(const FitTarget& target, const FitCode& code, const FitSamples& samples, bool single);

/// The shortest digits of a double, or of the nearest float where `single`.
std::string shortest_digits(double value, bool single);

/// `fit` as code, n in u where `n_in_u`, m where `m_in_u`; with the digits of floats where `single`.
FitCode as_code(const LambdaFit& fit, const FitTarget& target, bool n_in_u, bool m_in_u, bool single);

/// The code with its numbers as floats.
FitCode in_floats(FitCode code);

/// What `code` computes without rounding.
LambdaFit without_rounding(const FitCode& code, const FitTarget& target);

} // namespace brdfplot
