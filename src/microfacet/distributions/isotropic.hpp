/// \file
/// Distributions that are isotropic and not shape-invariant: what they share.
#pragma once

#include "microfacet/slopes.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace brdfplot {

/// A distribution of normals about the vertical. `Profile` has
/// - `static ModelSpec spec()` and `static Profile from(const Values&)`;
/// - `static std::optional<ParameterError> problem(const Values&)`, where parameters may not go together;
/// - `double width() const`: the slope that is the unit of `a_lambda`, about where most of the mass lies;
/// - `double p22(double r2) const`: slope density at squared slope r2;
/// - `double density(double sin2, double z) const`: D (1/sr) of the normal with that squared sine and cosine z > 0;
/// - `double a_lambda(double a) const`: a Lambda with a = cot(theta_o) / width, a in [0, infinity];
/// - `double slope_within(double u) const`, where it is a closed form: the slope within which a share u of the ground
/// lies, u in [0, 1).
template <class Profile>
struct Isotropic {
  SlopeMap slopes; ///< alpha_x = alpha_y = width
  Profile profile;

  static ModelSpec spec() { return Profile::spec(); }
  static Made<Isotropic> from(const Values& values) {
    if constexpr (requires { Profile::problem(values); })
      if (std::optional<ParameterError> error = Profile::problem(values)) return std::move(*error);
    const Profile profile = Profile::from(values);
    return Isotropic{{.alpha_x = profile.width(), .alpha_y = profile.width()}, profile};
  }
  static constexpr bool shape_invariant = false;

  double p22(double slope_x, double slope_y) const { return profile.p22(slope_x * slope_x + slope_y * slope_y); }
  double density(const Direction& omega_m) const {
    return omega_m.z > 0 ? profile.density(omega_m.x * omega_m.x + omega_m.y * omega_m.y, omega_m.z) : 0;
  }
  /// c Lambda = s a Lambda(a), as of ShapeInvariant.
  double masked_area(const Projection& p) const {
    const double below = p.c < 0 ? -p.c : 0;
    return p.s > 0 ? below + p.s * profile.a_lambda(std::fabs(p.c) / p.s) : below;
  }

  void masked_areas(const double* c, const double* s, double* t, std::size_t n) const {
    for (std::size_t k = 0; k < n; ++k) t[k] = masked_area({c[k], s[k]});
  }
  void densities(const kernels::Vectors<double>& m, double* d, std::size_t n) const {
    for (std::size_t k = 0; k < n; ++k) d[k] = density({m.x[k], m.y[k], m.z[k]});
  }
};

} // namespace brdfplot
