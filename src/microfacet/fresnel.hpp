/// \file
/// Fresnel reflectance of a microfacet: `reflectances(c, channel, f, n)` sets f to that of one channel at n cosines c
/// in [0, 1] between direction and facet normal; `losses` of the same arguments sets 1 - F, to a few roundings of
/// itself where F nears 1; `mean(channel)`, where there is a closed form, is mean_fresnel(). The list of types is at
/// the end. A type that is not smooth, or nearly so, declares where (`critical_cosine`), so that integrals can be cut
/// there. One that refracts what it does not reflect declares `relative_index(channel)`, and one with F = 1
/// `reflects_all`.
#pragma once

#include "models/parameters.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <variant>

namespace brdfplot {

/// F = 1.
struct NoFresnel {
  static constexpr bool reflects_all = true;

  static ModelSpec spec() {
    return {.type = "none", .doc = "a perfect mirror, F = 1", .source = "Heitz 2014, section 3.5"};
  }
  static NoFresnel from(const Values&) { return {}; }
  bool coloured() const { return false; }
  void reflectances(const double*, std::size_t, double* f, std::size_t n) const { std::fill_n(f, n, 1.0); }
  void losses(const double*, std::size_t, double* left, std::size_t n) const { std::fill_n(left, n, 0.0); }
  static double mean(std::size_t) { return 1; }
};

/// F = f0 + (f90 - f0) (1 - c)^exponent. RTR4, Eqs. 9.18 and 9.59, writes 1 / p for the exponent.
struct SchlickFresnel {
  Rgb f0{};
  Rgb f90{};
  double exponent = 5;
  bool is_rgb = false;

  static ModelSpec spec();
  static SchlickFresnel from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
  void losses(const double* c, std::size_t channel, double* left, std::size_t n) const;
  double mean(std::size_t channel) const; ///< f0 + 2 (f90 - f0) / ((n + 1) (n + 2)), n the exponent (RTR4, Eq. 9.59)
};

/// F = B - a c (1 - c)^6, B = f0 + (1 - f0) (1 - c)^5 Schlick's, a such that F is f82 B at c = 1/7, about 82 degrees,
/// where the second term is largest. Absolute error below 1e-15. Domain: f82 no less than least_f82(f0), from which on
/// F >= 0.
struct F82Fresnel {
  Rgb f0{};
  Rgb f82{};
  bool is_rgb = false;

  static ModelSpec spec();
  static Made<F82Fresnel> from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
  void losses(const double* c, std::size_t channel, double* left, std::size_t n) const;
  double mean(std::size_t channel) const; ///< f0 + (1 - f0) / 21 - a / 126

  static double coefficient(double f0, double f82); ///< a
  /// The f82 at which F touches 0: 0.51 for f0 = 0, 0 for f0 = 1.
  static double least_f82(double f0);
};

/// Unpolarised reflectance of a smooth dielectric of relative index eta; 1 under total internal reflection (eta < 1).
struct DielectricFresnel {
  Rgb eta{};
  bool is_rgb = false;

  static ModelSpec spec();
  static DielectricFresnel from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
  void losses(const double* c, std::size_t channel, double* left, std::size_t n) const;
  /// Light that is not reflected is refracted, and from beneath F is dielectric_reflectance() at 1 / relative_index.
  double relative_index(std::size_t channel) const { return eta[channel]; }
  /// The cosine up to which reflection is total, sqrt(1 - eta^2) of eta < 1: F falls from 1 like a root there.
  std::optional<double> critical_cosine(std::size_t channel) const;
};

/// Unpolarised reflectance of a conductor of relative index eta + i k.
struct ConductorFresnel {
  Rgb eta{};
  Rgb k{};
  bool is_rgb = false;

  static ModelSpec spec();
  static ConductorFresnel from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
  void losses(const double* c, std::size_t channel, double* left, std::size_t n) const;
  /// Where the real part of the squared index is sin^2: for k -> 0 reflection is total up to there, and for small k F
  /// changes within a narrow range about it.
  std::optional<double> critical_cosine(std::size_t channel) const;
};

/// Reflectance of one channel at the cosine `c` in [0, 1] between direction and facet normal (1), to the last bit that
/// of the kernels (math/kernels/kernels.hpp).
double schlick_reflectance(double c, double f0, double f90, double exponent);
double dielectric_reflectance(double c, double eta);
double conductor_reflectance(double c, double eta, double k);

using Fresnel = std::variant<NoFresnel,         //
                             SchlickFresnel,    //
                             F82Fresnel,        //
                             DielectricFresnel, //
                             ConductorFresnel>;

/// 2 int_0^1 F(c) c dc, the reflectance of one channel under light from everywhere (RTR4, Eq. 9.58): by a closed form,
/// to a few roundings, or by quadrature. Relative error below 1e-12. \throws AccuracyError where the quadrature says
/// otherwise.
double mean_fresnel(const Fresnel& fresnel, std::size_t channel);

} // namespace brdfplot
