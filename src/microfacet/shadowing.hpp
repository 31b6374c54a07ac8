/// \file
/// The joint masking-shadowing function G2 (Heitz 2014, section 6), written as V = G2 / (c_o c_i): the form in which
/// the BRDF needs it and in which nothing is 0 / 0 at grazing. The list of types is at the end. `kernel`, where a type
/// has it, names the form in which the batch kernels know it; `masked_area(projection, omega)`, where a type has it, is
/// a c Lambda of its own, whatever the masking function is.
#pragma once

#include "math/kernels/kernels.hpp"
#include "microfacet/direction_factor.hpp"
#include "microfacet/masking/karis.hpp"
#include "models/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace brdfplot {

/// What masking says of the two directions. u = c / G1 is the area seen if nothing were masked; with Smith-like masking
/// u = c + t, t = c Lambda. All are > 0 (t >= 0) where both directions are above the mesosurface.
struct MaskedPair {
  double c_o = 1, u_o = 1, t_o = 0;
  double c_i = 1, u_i = 1, t_i = 0;
  DirectionPair directions{}; ///< where a factor of the directions is asked
};

/// The declaration of `lambda` and its reading, shared by the two types that have it.
inline ParameterSpec direction_factor_parameter() {
  return {
      .key = "lambda",
      .kind = ParameterKind::choice,
      .doc = "factor of the azimuth difference (RTR4, Eqs. 9.29-9.30), or of both directions, fitted to surfaces; with "
             "Smith's own Lambda the fitted one makes G2 worse: docs/direction_factor.md",
      .choices = direction_factor_names()};
}

inline DirectionFactor direction_factor_from(const Values& values) {
  const auto& names = direction_factor_names();
  return static_cast<DirectionFactor>(std::ranges::find(names, values.text("lambda")) - names.begin());
}

/// V of G2 = 1 / (1 + Lambda(o) + Lambda(i)).
inline double height_correlated_visibility(const MaskedPair& p) {
  return 1 / (p.c_o * p.c_i + p.c_i * p.t_o + p.c_o * p.t_i);
}

/// V of min(G1(o), G1(i)).
inline double minimum_visibility(const MaskedPair& p) { return 1 / std::max(p.c_i * p.u_o, p.c_o * p.u_i); }

struct NoShadowing {
  static ModelSpec spec() {
    return {.type = "none", .doc = "G2 = G1(o): masking alone", .source = "Heitz 2014, Eq. 35"};
  }
  static NoShadowing from(const Values&) { return {}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = false; ///< has a kink where G1(o) = G1(i)
  static constexpr kernels::Shadowing kernel = kernels::Shadowing::none;
  double visibility(const MaskedPair& p) const { return 1 / (p.c_i * p.u_o); }
};

struct Separable {
  static ModelSpec spec() {
    return {.type = "separable",
            .doc = "G2 = G1(o) G1(i)",
            .source = "Walter et al. 2007; Heitz 2014, Eq. 98; Akenine-Moller et al. 2018, Eq. 9.27"};
  }
  static Separable from(const Values&) { return {}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = false;
  static constexpr kernels::Shadowing kernel = kernels::Shadowing::separable;
  double visibility(const MaskedPair& p) const { return 1 / (p.u_o * p.u_i); }
};

struct Minimum {
  static ModelSpec spec() {
    return {.type = "minimum",
            .doc = "G2 = min(G1(o), G1(i)): exact for V-cavities",
            .source = "Cook and Torrance 1982; Kelemen and Szirmay-Kalos 2001, appendix"};
  }
  static Minimum from(const Values&) { return {}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = true;
  static constexpr kernels::Shadowing kernel = kernels::Shadowing::minimum;
  double visibility(const MaskedPair& p) const { return minimum_visibility(p); }
};

struct HeightCorrelated {
  static ModelSpec spec() {
    return {.type = "height_correlated",
            .doc = "G2 = 1 / (1 + Lambda(o) + Lambda(i))",
            .source = "Ross et al. 2005; Heitz 2014, Eq. 99; Akenine-Moller et al. 2018, Eq. 9.31"};
  }
  static HeightCorrelated from(const Values&) { return {}; }
  static constexpr bool needs_lambda = true;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = false;
  static constexpr kernels::Shadowing kernel = kernels::Shadowing::height_correlated;
  double visibility(const MaskedPair& p) const { return height_correlated_visibility(p); }
};

struct DirectionCorrelated {
  DirectionFactor lambda = DirectionFactor::ginneken;

  static ModelSpec spec() {
    return {.type = "direction_correlated",
            .doc = "G2 = lambda G1(o) G1(i) + (1 - lambda) min(G1(o), G1(i))",
            .source = "Ashikhmin et al. 2000; Heitz 2014, Eq. 100; Akenine-Moller et al. 2018, Eq. 9.28",
            .parameters = {direction_factor_parameter()}};
  }
  static DirectionCorrelated from(const Values& values) { return {direction_factor_from(values)}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = true;
  static constexpr bool compares = true;
  double visibility(const MaskedPair& p) const {
    const DirectionCorrelation by = direction_correlation(lambda, p.directions);
    return by.lambda / (p.u_o * p.u_i) + by.complement * minimum_visibility(p);
  }
};

struct HeightDirectionCorrelated {
  DirectionFactor lambda = DirectionFactor::ginneken;

  static ModelSpec spec() {
    return {.type = "height_direction_correlated",
            .doc = "G2 = 1 / (1 + max(Lambda(o), Lambda(i)) + lambda min(Lambda(o), Lambda(i)))",
            .source = "van Ginneken et al. 1998; Heitz 2014, Eq. 101; Akenine-Moller et al. 2018, Eq. 9.32",
            .parameters = {direction_factor_parameter()}};
  }
  static HeightDirectionCorrelated from(const Values& values) { return {direction_factor_from(values)}; }
  static constexpr bool needs_lambda = true;
  static constexpr bool needs_azimuth = true;
  static constexpr bool compares = true;
  double visibility(const MaskedPair& p) const {
    const double o = p.c_i * p.t_o;
    const double i = p.c_o * p.t_i;
    const double factor = direction_correlation(lambda, p.directions).lambda;
    return 1 / (p.c_o * p.c_i + std::max(o, i) + factor * std::min(o, i));
  }
};

/// V = 1 / (alpha (c_o + c_i) / 2 + (1 - alpha) c_o c_i): what `height_correlated` is with masking `karis`, so with its
/// Lambda on anisotropic and sheared surfaces.
struct Hammon {
  static ModelSpec spec() {
    return {.type = "hammon",
            .doc = "G2 / (4 NL NV) = 0.5 / lerp(2 NL NV, NL + NV, alpha), whatever G1 is: off by up to 0.233 for GGX",
            .source = "Hammon 2017; Akenine-Moller et al. 2018, Eq. 9.45"};
  }
  static Hammon from(const Values&) { return {}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = false;
  static double masked_area(const Projection& p, const Direction& omega) { return Karis::masked_area(p, omega); }
  double visibility(const MaskedPair& p) const { return height_correlated_visibility(p); }
};

/// V = 1 / (c_o + c_i - c_o c_i): 1 / (1 + Lambda(o) + Lambda(i)) with 1 + Lambda = 1 / c, the G1 of masking
/// `implicit`. On sheared surfaces c is the cosine after the shear that levels the mesosurface.
struct Neubelt {
  static ModelSpec spec() {
    return {.type = "neubelt",
            .doc = "G2 = NL NV / (NL + NV - NL NV), whatever G1 is: the denominator 4 (NL + NV - NL NV)",
            .source = "Neubelt and Pettineo 2013; Akenine-Moller et al. 2018, Eq. 9.74"};
  }
  static Neubelt from(const Values&) { return {}; }
  static constexpr bool needs_lambda = false;
  static constexpr bool needs_azimuth = false;
  static constexpr bool compares = false;
  /// n - c, n the length of the direction after that shear: 1 - c where there is none.
  static double masked_area(const Projection& p, const Direction& omega) { return sheared_versine(p, omega); }
  double visibility(const MaskedPair& p) const { return height_correlated_visibility(p); }
};

using Shadowing = std::variant<NoShadowing,               //
                               Separable,                 //
                               Minimum,                   //
                               HeightCorrelated,          //
                               DirectionCorrelated,       //
                               HeightDirectionCorrelated, //
                               Hammon,                    //
                               Neubelt>;

} // namespace brdfplot
