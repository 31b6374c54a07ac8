/// \file
/// The directional albedo of a material as a rational that stays within [0, 1], for shaders.
#pragma once

#include "analysis/fit/code.hpp"
#include "analysis/integrals.hpp"

#include <optional>

namespace brdfplot {

struct AlbedoFitOptions {
  Integral quantity = Integral::albedo; ///< or furnace: the same with F = 1
  double tolerance = 1e-3;              ///< largest absolute error, in (0, 0.1]
  bool fixed = false;                   ///< alpha is a constant
  int threads = 1;
};

/// E(cos theta, alpha) = N / (N + M), N and M sums of n_ij x^i u^(d_x - i) y^j v^(d_y - j) with n_ij, m_ij >= 0 and
///   x = cos theta / (cos theta + k), u = k / (cos theta + k), in which the shoulder of a narrow lobe has one width,
///   y = (alpha - from) / (to - from), v = (to - alpha) / (to - from);
/// k = alpha where that is an argument. No term is negative: N / (N + M) lies in [0, 1] whatever is rounded, and
/// nothing cancels.
struct AlbedoForm {
  bool by_alpha = true;       ///< else dy = 0
  double from = 0.01, to = 1; ///< alpha beyond counts as at these ends
  double k = 1;               ///< where alpha is no argument
  std::size_t dx = 0, dy = 0;
  std::vector<float> n, m; ///< n_ij at j (dx + 1) + i

  template <class Real>
  Real value(Real cos_theta, Real alpha) const;
};

struct AlbedoFit {
  std::string material;
  Integral quantity = Integral::albedo;
  AlbedoForm form;
  double asked = 0;
  double in_double = 0, in_float = 0; ///< largest absolute errors at `places`
  double cosine = 0, alpha = 0;       ///< where that in double is
  std::size_t places = 0;             ///< between those of the fit, and on the rims
  double of_integrals = 0;            ///< what the integrals themselves may be off by
};

/// The form of fewest coefficients that is found within the tolerance, over cos theta in [0, 1] and, where the material
/// has one alpha and it is not `fixed`, over alpha in [0.01, 1]. Its coefficients are the solution of a linear program
/// (maximin.hpp): |N - E (N + M)| <= tolerance (N + M) at a grid of places.
/// \throws InputError where the albedo has several channels or depends on the azimuth; AccuracyError where no form is
/// within the tolerance, or an integral is not
AlbedoFit fit_albedo(const MaterialDescription& material, const AlbedoFitOptions& options);

std::vector<std::string> describe(const AlbedoFit& fit);

/// The function NAME_albedo, or NAME_furnace, of a cosine and, where the form has it, alpha; 0 is not special: below
/// the horizon the cosine counts as 0. Languages as fit_code() has them.
std::string fit_code(const AlbedoFit& fit, FitLanguage language);

} // namespace brdfplot
