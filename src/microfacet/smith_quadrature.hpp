/// \file
/// Smith's Lambda of any isotropic distribution of slopes, by quadrature.
#pragma once

#include <functional>
#include <limits>
#include <vector>

namespace brdfplot {

/// ln of a slope density at a squared slope; -infinity where the density is 0. The logarithm, so that a Lambda of
/// 1e-300 has as many digits as one of 1.
using LogDensity = std::function<double(double r2)>;

/// What is known of a density besides: where the quadrature must look, and how it ends.
struct DensityHints {
  std::vector<double> cuts{}; ///< squared slopes, rising: peaks, and where they are left
  /// Falls like r2^-power from r2 = 1e30 on.
  double power = std::numeric_limits<double>::infinity();
};

/// a Lambda(a) for an isotropic density of slopes p(r):
///   a Lambda(a) = 2 int_0^inf p(sqrt(a^2 + t^2)) t (t - a atan(t / a)) dt,
/// Heitz 2014, Eqs. 40-43 in polar slopes r^2 = a^2 + t^2; every term is positive, so nothing cancels. With the density
/// of unit roughness of a shape-invariant distribution, a is that of Eq. 63; with P22 itself, cot theta_o.
/// Domain a >= 0, p r^2 integrable over r. Without hints p must have one peak, at 0, and fall faster than r^-3.3.
/// Limits: the mean slope along one axis, int p r^2 dr, times 2 at a = 0; 0 at infinity, and from a = 1e75 on, where
/// Lambda < 1e-149 and a^3 would overflow soon. Error: 1e-10 relative, or 1e-200, whichever is more; of a density that
/// is analytic, about 1e-13 and 2^-52 times the largest logarithm. \throws AccuracyError when the estimate is above.
double a_lambda_by_quadrature(const LogDensity& log_density, double a, const DensityHints& hints = {});

} // namespace brdfplot
