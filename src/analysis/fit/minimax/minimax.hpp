/// \file
/// The best coefficients of one rational form.
#pragma once

#include "analysis/fit/form.hpp"

#include <optional>
#include <vector>

namespace brdfplot {

/// The true Lambda at a and y.
struct FitSample {
  double a = 0;
  double y = 0;
  double lambda = 0;
};

/// Samples in lines of constant y, `per_line` to a line, in the order of a.
struct FitSamples {
  std::size_t per_line = 0;
  std::vector<FitSample> samples{};
};

/// The sample with the largest |relative error of G1|, and that error.
struct FitError {
  double error = 0;
  FitSample where{};
};

FitError largest_error(const LambdaFit& fit, const FitSamples& samples);

/// A fit of the form whose relative error of G1 is at most `tolerance` at all samples; nothing where there is none.
///
/// |x m Lambda - (1 - x)^p n| <= tolerance (x m + (1 - x)^p n) is linear in the coefficients, and G1 of the fit is the
/// rational x m / (x m + (1 - x)^p n) itself: so whether there is a fit is a linear program, in any number of variables
/// (fit_maximin.hpp), and no iteration is needed for the nonlinearity of 1 / (1 + Lambda). That (1 - x)^p n / x falls,
/// and so is not negative, is one more row a sample: linear too, and most of what G1 needs to increase. The program is
/// given few samples, then those where its answer is worst, until it holds at all.
/// `near`: an earlier fit, by whose denominators the rows are divided. Where `rising` is given, one more row a sample
/// asks that G1 increase with a, at the samples that it names too: linearized at the earlier fit, since that is a
/// product of coefficients of n and m.
std::optional<LambdaFit> fit_within(double tolerance, const RationalForm& form, const FitSamples& samples,
                                    const LambdaFit* near = nullptr, const std::vector<std::size_t>* rising = nullptr);

/// The fit with the smallest largest relative error of G1, within 1 %; nothing where none is below `tolerance`.
/// Differential correction (Cheney and Loeb 1961; Barrodale, Powell and Roberts 1972): the error of one program is the
/// tolerance of the next.
std::optional<LambdaFit> minimax_fit(double tolerance, const RationalForm& form, const FitSamples& samples);

/// minimax_fit() where that is proved sound (LambdaFit::proved_sound); else one that is, as good as is found, and
/// within the tolerance; nothing where there is none.
std::optional<LambdaFit> sound_fit(double tolerance, const RationalForm& form, const FitSamples& samples);

} // namespace brdfplot
