/// \file
/// Fresnel reflectance of a microfacet: `reflectances(c, channel, f, n)` sets f to that of one channel at n cosines c
/// in [0, 1] between direction and facet normal. The list of types is at the end. A type that is not smooth, or nearly
/// so, declares where (`critical_cosine`), so that integrals can be cut there. A type that refracts what it does not
/// reflect declares `relative_index(channel)`, and one with F = 1 `reflects_all`.
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
};

/// F = f0 + (f90 - f0) (1 - c)^exponent.
struct SchlickFresnel {
  Rgb f0{};
  Rgb f90{};
  double exponent = 5;
  bool is_rgb = false;

  static ModelSpec spec();
  static SchlickFresnel from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
};

/// Unpolarised reflectance of a smooth dielectric of relative index eta; 1 under total internal reflection (eta < 1).
struct DielectricFresnel {
  Rgb eta{};
  bool is_rgb = false;

  static ModelSpec spec();
  static DielectricFresnel from(const Values& values);
  bool coloured() const { return is_rgb; }
  void reflectances(const double* c, std::size_t channel, double* f, std::size_t n) const;
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
                             DielectricFresnel, //
                             ConductorFresnel>;

} // namespace brdfplot
