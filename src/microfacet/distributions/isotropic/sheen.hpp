/// \file
/// Imageworks' sheen (Estevez and Kulla 2017): a power of the sine, with its exact masking.
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/isotropic.hpp"

#include <optional>

namespace brdfplot {

/// D = (2 + 1 / alpha) sin^(1 / alpha) / (2 pi) (RTR4, Eq. 9.75).
struct SheenProfile {
  double alpha = 0.5;                  ///< r of the paper
  std::optional<ALambdaTable> table{}; ///< of exact_a_lambda(), which takes a hundred times as long

  static ModelSpec spec();
  static SheenProfile from(const Values& values);

  double width() const { return std::sqrt(1 + half_power()); }
  double half_power() const { return 0.5 / alpha; } ///< m below
  double p22(double r2) const;
  /// Where sin^(2 + 1 / alpha) = u.
  double slope_within(double u) const {
    const double log_sin2 = std::log(u) / (1 + half_power());
    return std::exp(0.5 * log_sin2) / std::sqrt(-std::expm1(log_sin2));
  }
  double density(double sin2, double z) const;
  /// c Lambda = (F - c) / 2, F = 2F1(-1/2, -m; 1; sin^2), m = 1 / (2 alpha): D is even in cos theta_m, so the visible
  /// area is half of c and half of the cosine transform F of D over the sphere. F is computed as
  ///   (2 / pi) int_0^(pi/2) (1 - x sin^2 f)^m (c^2 + 2 (m + 1) x cos^2 f) df,  x = sin^2,
  /// which follows from Gauss's contiguous relations and has no negative term; where (m + 1) x < 1/2, F - c by its
  /// power series. Relative error < 5e-13.
  double exact_a_lambda(double a) const;
  /// The same, by the table where there is one. Relative error < 1e-12.
  double a_lambda(double a) const { return table ? (*table)(a) : exact_a_lambda(a); }
};

using Sheen = Isotropic<SheenProfile>;

} // namespace brdfplot
