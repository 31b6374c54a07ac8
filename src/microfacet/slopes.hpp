/// \file
/// The affine map that stretches, correlates and shears a unit-roughness distribution of slopes: written once for every
/// shape-invariant model (Heitz 2014, section 5).
#pragma once

#include "math/direction.hpp"
#include "math/kernels/kernels.hpp"
#include "models/parameters.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot {

/// A direction as a distribution of slopes sees it.
struct Projection {
  double c = 1; ///< projected area of the mesosurface (cos theta when centred)
  double s = 0; ///< projected roughness, alpha_o sin theta; a = c / s
};

/// n - c of a direction after the vertical shear that levels the mesosurface, with n^2 = x^2 + y^2 + c^2 the square of
/// its length, as h^2 / (n + c), h^2 = x^2 + y^2, which does not cancel. 1 - cos theta when centred.
inline double sheared_versine(const Projection& p, const Direction& omega) {
  const double h = std::hypot(omega.x, omega.y);
  return h * (h / (std::hypot(h, p.c) + p.c));
}

/// Slopes m~ = mean + L u, with |u| the norm of Eq. 89 and L L^T = Q^-1 (Eq. 88).
struct SlopeMap {
  double alpha_x = 1;
  double alpha_y = 1;
  double correlation = 0; ///< r_xy in (-1, 1)
  double mean_x = 0;      ///< slope of the mesosurface (Eq. 94)
  double mean_y = 0;

  /// sqrt(1 - r^2) without the cancellation of 1 - r^2 for |r| near 1.
  double decorrelation() const { return std::sqrt((1 - correlation) * (1 + correlation)); }

  /// det L: the area by which the map multiplies.
  double determinant() const { return alpha_x * alpha_y * decorrelation(); }

  /// c and s of Eqs. 96-97: a = c / s, projected area of the mesosurface c = z - x mean_x - y mean_y (section 5.5), and
  /// s = |L^T (x, y)| as a sum of squares, so that it does not cancel for |r| near 1.
  Projection project(const Direction& omega) const {
    const Vec2 h = on_unit_surface(omega);
    return {omega.z - omega.x * mean_x - omega.y * mean_y, std::hypot(h[0], h[1])};
  }

  /// L^T (x, y): the horizontal part of a direction after the map that makes the slopes those of unit roughness.
  Vec2 on_unit_surface(const Direction& omega) const {
    return {alpha_x * omega.x + correlation * alpha_y * omega.y, decorrelation() * alpha_y * omega.y};
  }

  /// mean + L (u, v): the slope whose unit slope is (u, v).
  Vec2 slope(double u, double v) const {
    return {mean_x + alpha_x * u, mean_y + alpha_y * (correlation * u + decorrelation() * v)};
  }

  /// z_m^2 |u|^2 for the slope of the normal omega_m: the norm of Eq. 95 without a division by z_m.
  double scaled_norm2(const Direction& omega_m) const {
    const double u = (-omega_m.x - mean_x * omega_m.z) / alpha_x;
    const double v = (-omega_m.y - mean_y * omega_m.z) / alpha_y;
    const double w = (v - correlation * u) / decorrelation();
    return u * u + w * w;
  }

  /// As the kernels want it.
  kernels::Stretch stretch() const { return {alpha_x, alpha_y, correlation, mean_x, mean_y}; }

  bool centred() const { return mean_x == 0 && mean_y == 0; }

  /// The parameters `alpha`, alone or with the length of a filtered normal (toksvig_alpha()), or `alpha_x` and
  /// `alpha_y`, or `roughness` alone, with an anisotropy or with the convention of a renderer; `correlation`;
  /// `mean_slope`.
  static std::vector<ParameterSpec> parameters();
  static std::vector<std::vector<std::string>> alternatives() {
    return {{"alpha"},
            {"alpha_x", "alpha_y"},
            {"roughness"},
            {"roughness", "disney_anisotropy"},
            {"roughness", "imageworks_anisotropy"},
            {"roughness", "roughness_convention"},
            {"alpha", "mean_normal_length"}};
  }
  /// What makes the roughness of Gaussian slopes from those of a normal map: `slope_moments`, the second moments E[xx],
  /// E[yy], E[xy] of slopes whose mean is `mean_slope`, of which the covariance E[m m^T] - mean mean^T, with alpha^2 /
  /// 2 of the base added on the diagonal, is alpha^2 / 2 of the whole (LEAN: Olano and Baker 2010); and
  /// `slope_variance`, the variance v along any axis that a normal map lost, alpha'^2 = alpha^2 + 2 v (variance
  /// mapping: Akenine-Moller et al. 2018, section 9.13.1). Error: a rounding of the second moments, which is many of
  /// their difference with the square of a large mean.
  static std::vector<ParameterSpec> moments();
  static std::vector<std::vector<std::string>> moment_alternatives() {
    return {{"alpha", "slope_moments"}, {"alpha", "slope_variance"}};
  }
  static SlopeMap from(const Values& values);
  /// Of two parameters together: a roughness that no renderer takes, an alpha whose lobe Toksvig does not widen, second
  /// moments that no slopes of that mean have.
  static std::optional<ParameterError> problem(const Values& values);
  /// Of parameters that are good one by one: a roughness that an anisotropy takes out of [1e-6, 1e6], or two more than
  /// 1e6 apart. Within, everything there is to evaluate is finite.
  std::optional<ParameterError> problem() const;
};

/// The alpha, or the exponent n of a power of the cosine, of a surface whose normals vary about their mean, of which
/// `length` in (0, 1] is left: n' = |N| n / (|N| + n (1 - |N|)) (Toksvig 2005; Akenine-Moller et al. 2018, Eq. 9.76),
/// and of alpha by n = 2 / alpha^2 - 2. Without the cancellation of n for alpha near 1, where n is 0 and stays. Domain
/// alpha <= 1, n >= 0.
double toksvig_alpha(double alpha, double length);
double toksvig_exponent(double exponent, double length);
/// `mean_normal_length` of the two.
ParameterSpec mean_normal_length();

/// The parameters of a distribution with one alpha: `alpha` within bounds, or `roughness`, its root.
std::vector<ParameterSpec> isotropic_roughness(const Bounds& bounds, const std::string& doc);
/// The alpha that they say.
double alpha_from(const Values& values);

} // namespace brdfplot
