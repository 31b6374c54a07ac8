/// \file
/// The linear program behind a rational fit.
#pragma once

#include <cstddef>
#include <vector>

namespace brdfplot {

/// Rows of equal length, one after the other.
struct Rows {
  std::size_t columns = 0;
  std::vector<double> values{};

  std::size_t count() const { return columns ? values.size() / columns : 0; }
};

struct Maximin {
  double value = 0;        ///< smallest entry of A v
  double bound = 0;        ///< no v has a larger one
  std::vector<double> v{}; ///< |v_i| < 1
};

/// A v in [-1, 1]^n whose smallest entry of A v is positive and within 10 % of the largest possible; or, where the
/// bound is below 1e-11, the proof that there is none. By an interior-point method (Mehrotra 1992), which the many
/// equal entries of such rows do not hold up as they do the simplex method; all that is returned is computed from v and
/// from the multipliers themselves, so that rounding cannot make it wrong.
Maximin maximin(const Rows& a);

} // namespace brdfplot
