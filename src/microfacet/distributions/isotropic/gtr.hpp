/// \file
/// Generalized Trowbridge-Reitz (Burley 2012), with its own Smith masking.
#pragma once

#include "microfacet/a_lambda_table.hpp"
#include "microfacet/distributions/isotropic.hpp"

namespace brdfplot {

/// The normals of GTR, by logarithms whose terms do not cancel however sharp the peak is.
struct GtrLobe {
  double alpha;
  double gamma;
  double log_peak; ///< ln of the largest D: k alpha^(-2 gamma) / pi at the normal, for alpha >= 1 k / pi at the horizon

  GtrLobe(double alpha, double gamma);
  /// The peak over the power gamma of 1 + (alpha^-2 - 1) sin^2, for alpha >= 1 of 1 + (alpha^2 - 1) cos^2.
  double log_density(double sin2, double z2) const;
  /// The slope within which half of the normals are, by area: alpha for gamma = 2, elsewhere by orders of magnitude as
  /// alpha goes to 0 or infinity. With v = alpha^2 + (1 - alpha^2) sin^2, int D cos is one over v^-gamma.
  double median_slope() const;
  /// The slope within which a share u of the ground lies: v of median_slope() from alpha^2 at u = 0 to 1 at u = 1.
  double slope_within(double u) const;
  double log_p22(double r2) const; ///< of k / pi (1 + r2)^(gamma - 2) / (r2 + alpha^2)^gamma
};

/// D = k / (pi (1 + (alpha^2 - 1) cos^2)^gamma) (RTR4, Eqs. 9.46-9.47); gamma = 2 is GGX. Not shape-invariant. Domain
/// alpha in [1e-6, 1e6], gamma in (0, 1000].
struct GtrProfile {
  GtrLobe lobe;
  ALambdaTable table;

  static ModelSpec spec();
  static GtrProfile from(const Values& values);

  double width() const { return lobe.alpha; }
  double typical_slope() const { return lobe.median_slope(); }
  double p22(double r2) const { return std::exp(lobe.log_p22(r2)); }
  double slope_within(double u) const { return lobe.slope_within(u); }
  double density(double sin2, double z) const { return std::exp(lobe.log_density(sin2, z * z)); }
  /// For gamma = 1, 2, 3, 4 the closed forms below; else from a table of the quadrature of these slopes, relative error
  /// 1e-10 of all that is above 1e-290.
  double a_lambda(double a) const;
};

using Gtr = Isotropic<GtrProfile>;

/// ln k of RTR4, Eq. 9.47, continuous through gamma = 1 and alpha = 1: with phi(x) = (e^x - 1) / x and L = ln alpha^2,
/// k = phi(L) / phi((1 - gamma) L).
double gtr_log_normalization(double alpha, double gamma);

/// a Lambda(a) in closed form, for gamma = 1, 2, 3, 4 (Dimov 2015, whose G1 these are, rewritten as sums of terms of
/// one sign, so that nothing cancels at the normal, at grazing or near alpha = 1). With h = sqrt(1 + a^2):
///   1: phi(L) (1 - k ln(1 + d) / d) / (alpha (A + B)), L = ln alpha^2, A = alpha h, B = sqrt(1 + (alpha a)^2),
///      k = alpha a / (alpha a + B), d = (alpha^2 - 1) / ((A + B) (alpha a + B))
///   2: 1 / (2 (a + h)), as GGX
///   3: (2 alpha^2 / (1 + alpha^2) + 1 / (a + h)^2) / (4 h)
///   4: (12 alpha^4 h^2 + 3 alpha^2 + Q y (1 + y) / 2) / (2 Q h^3), Q = 8 (alpha^4 + alpha^2 + 1), y = 1 / (2 (a +
///   h)^2)
/// Relative error 1e-14; a in [0, infinity]. \pre gamma is one of them.
double gtr_a_lambda_closed(double alpha, int gamma, double a);

} // namespace brdfplot
