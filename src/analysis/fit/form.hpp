/// \file
/// The rational form in which Smith's Lambda is fitted.
#pragma once

#include "analysis/fit/minimax/polynomial.hpp"

namespace brdfplot {

/// Lambda(a, y) = (1 - x)^power n(x, y) / (x m(x, y)), a = cot theta / alpha, y in [0, 1] what else it depends on, with
///   x = a / (scale + a)       over all of [0, infinity], or
///   x = min(a / scale, 1)     where `cut`: Lambda = 0 from a = scale on.
/// Either is a rational of a. It has the pole of every Lambda at grazing and is exactly 0 at the normal, so that
/// G1 = x m / (x m + (1 - x)^power n) is 0 at grazing and 1 at the normal, without a quotient 0 / 0 at either.
struct RationalForm {
  bool cut = false;
  double scale = 1;
  int power = 1;
  std::size_t nx = 0; ///< degree of n in x
  std::size_t ny = 0; ///< in y
  std::size_t mx = 0;
  std::size_t my = 0;

  double x(double a) const;
  /// (1 - x)^power without the cancellation of 1 - x at large a.
  double vanishing(double a) const;
  std::size_t coefficients() const { return (nx + 1) * (ny + 1) + (mx + 1) * (my + 1); }
};

/// What one G1 costs, from the cosine and alpha sin theta (and y) on.
struct FitCost {
  int operations = 0; ///< multiply-adds; a lone product, sum or maximum counts as one
  int divisions = 0;

  /// In multiply-adds. A division takes about as long as four on today's processors, central and graphical.
  int total() const { return operations + 4 * divisions; }
};

FitCost cost_of(const RationalForm& form);

/// A form with its coefficients.
struct LambdaFit {
  RationalForm form;
  Polynomial n; ///< its constant coefficient is 1
  Polynomial m;

  /// a in (0, infinity).
  double lambda(double a, double y) const;
  /// G1(a, y) / G1 - 1 where the true Lambda is `truth`, without cancellation.
  double relative_error(double a, double y, double truth) const;
  /// The derivative of G1 by a times positive factors: power n x m + (1 - x) (n (m + x m') - n' x m).
  Polynomial scaled_slope() const;
  /// Whether these are proved on [0, 1]^2: n > 0 and m > 0, hence no pole and G1 in [0, 1]; G1 increases with a.
  bool proved_sound() const;
};

} // namespace brdfplot
