/// \file
/// The cheapest rational fit of Smith's Lambda whose masking is as accurate as asked.
#pragma once

#include "analysis/fit/accuracy.hpp"

namespace brdfplot {

struct FitOptions {
  double tolerance = 1e-4; ///< largest relative error of G1, in (0, 0.1]
  bool fixed = false;      ///< all parameters of the material are constants (see fit_target)
  int threads = 1;
};

struct FitResult {
  FitTarget target;
  FitCode code;          ///< what is written
  LambdaFit fit;         ///< what it is without rounding
  FitAccuracy in_double; ///< of the code; samples denser than those of the fit
  FitAccuracy in_float;
  bool single = true; ///< whether the coefficients are floats
};

/// A cheap form of RationalForm within the tolerance: minimax in the relative error of G1 over all a in [0, infinity]
/// and the domain of the parameter, proved to have no pole, G1 in [0, 1] and G1 increasing with cos theta
/// (LambdaFit::proved_sound). The tolerance holds in double, and in float too where a form does that is little dearer:
/// where rounding takes more than the fit leaves, it is fitted again to what rounding leaves, if that is half at least.
/// In one variable forms are tried in the order of their cost, and of the first cost at which any is within the
/// tolerance the most accurate is returned: powers 1, 2, 3, 4, 6 and 8, degrees up to 6, with and without a cut, the
/// scale optimized. In two the search is greedy: of the first equal degrees that are within the tolerance, degrees are
/// lowered one at a time (powers 1, 2 and 4, no cut, degrees up to 6 in a and 5 in the parameter); a cheaper form may
/// exist, and where the minimax of a form is not sound, part of the tolerance is given up for one that is. \throws
/// AccuracyError when none is; it gives the best error reached. InputError: see fit_target.
FitResult fit_lambda(const MaterialDescription& description, const FitOptions& options);

/// The most accurate sound fit of one form at the best scale; nothing where there is none within `tolerance`.
std::optional<LambdaFit> fit_form(RationalForm form, double tolerance, const FitSamples& samples);

} // namespace brdfplot
