/// \file
/// The Phong distribution of normals (Walter et al. 2007), with its own Smith masking.
#pragma once

#include "microfacet/distributions/isotropic.hpp"
#include "microfacet/distributions/student_t.hpp"

namespace brdfplot {

/// D = (n + 2) / (2 pi) cos^n theta_m. Its slopes, P22 = (n + 2) / (2 pi) (1 + r2)^(-(n + 4) / 2), are those of
/// Student's t with gamma = n / 2 + 2 and alpha = sqrt(2 / (n + 2)); not shape-invariant, since n changes gamma too.
/// Domain n > -1 (the mean slope is infinite from there down) to 2e12, where alpha is 1e-6.
struct PhongProfile {
  double exponent = 0;
  double alpha = 1; ///< of the Beckmann surface that is about as rough, sqrt(2 / (n + 2)) (Walter et al. 2007)
  StudentTShape shape;

  static ModelSpec spec();
  static PhongProfile from(const Values& values);
  /// An exponent below 0, which Toksvig's formula does not widen, beside `mean_normal_length`.
  static std::optional<ParameterError> problem(const Values& values);

  double width() const { return alpha; }
  double p22(double r2) const;
  /// Where cos^(n + 2) = 1 - u.
  double slope_within(double u) const { return std::sqrt(std::expm1(-2 / (exponent + 2) * std::log1p(-u))); }
  /// cos^n through log1p of tan^2, exact near the normal however large n is. Where n < 0, D grows without bound towards
  /// the horizon; normals nearer to it than 1e-150 count as there.
  double density(double sin2, double z) const;
  /// The closed form of Student's t, with its error bound.
  double a_lambda(double a) const { return shape.a_lambda(a); }
};

using Phong = Isotropic<PhongProfile>;

} // namespace brdfplot
