/// \file
/// a Lambda(a) of a density without a closed form, interpolated.
#pragma once

#include "microfacet/smith_quadrature.hpp"

#include <functional>
#include <memory>
#include <utility>

namespace brdfplot {

/// a_lambda_by_quadrature() at the price of an exponential: ln(a Lambda) in Chebyshev polynomials of degree 20 of
/// ln(1 + a), on intervals halved until the last coefficients are below 2e-12. Error as of the quadrature: 1e-10 of a
/// Lambda, or 1e-200 where that is more; where the density is analytic, 1e-10 of it down to 1e-290. From 1e-300 down it
/// is 0; on intervals where the density has a kink, the quadrature itself is asked. Intervals are made when they are
/// first needed, in a fraction of a millisecond each; which ones there are, and every value, does not depend on what
/// was asked before. Copies share the table; threads may.
class ALambdaTable {
public:
  explicit ALambdaTable(LogDensity log_density, DensityHints hints = {});
  /// Of an a Lambda that is known but takes long, smooth for a > 0: the same with the last coefficients below 1e-13.
  /// Adds 5e-13 to its relative error.
  static ALambdaTable of_exact(std::function<double(double)> a_lambda);

  /// a Lambda(a), a in [0, infinity]. \throws AccuracyError as a_lambda_by_quadrature().
  double operator()(double a) const;

private:
  class Blocks;
  explicit ALambdaTable(std::shared_ptr<Blocks> blocks) : blocks_(std::move(blocks)) {}
  std::shared_ptr<Blocks> blocks_;
};

} // namespace brdfplot
