/// \file
/// The Lambda of a material as what a fit is a function of.
#pragma once

#include "analysis/fit/minimax/minimax.hpp"
#include "brdf/material.hpp"

#include <functional>
#include <optional>
#include <string>

namespace brdfplot {

/// A parameter of a model that a fit takes as an argument, as y = offset + factor q, where q is the parameter, or
/// 1 / (parameter + shift) where `reciprocal`.
struct FitParameter {
  std::string key;
  double from = 0; ///< its domain; `to` may be infinity
  double to = 1;
  bool reciprocal = false;
  double shift = 0;
  double offset = 0;
  double factor = 1;

  bool contains(double value) const { return value >= from && value <= to; }
  /// "gamma >= 1.75", "alpha in [0.05, 1]".
  std::string domain() const;
  double y(double value) const;
  /// The parameter at a y in [0, 1]; finite.
  double value(double y) const;
};

/// Where alpha in a = cot theta / alpha comes from.
enum class FitAlpha {
  argument,  ///< shape-invariant: alpha_o, any: the code takes alpha, or vectors and what SlopeMap makes s of
  parameter, ///< it is the parameter
  root_of_y, ///< sqrt(y): Phong's equivalent alpha, sqrt(2 / (n + 2))
  constant,  ///< the material's, all of whose parameters are fixed
};

struct FitTarget {
  std::string name; ///< of the material
  std::string type; ///< of its distribution
  std::string masking;
  std::string constants{}; ///< the parameters that are fixed: "gamma = 3"
  FitAlpha alpha = FitAlpha::argument;
  double alpha_value = 1; ///< FitAlpha::constant
  std::optional<FitParameter> parameter{};
  SlopeMap slopes{};                           ///< the material's
  std::string shadowing = "height_correlated"; ///< the form of G2
  std::string factor{};                        ///< its factor of the azimuth, if it has one
  /// Lambda as a function of a, at a y.
  std::function<std::function<double(double a)>(double y)> lambda_at;

  /// Whether Lambda has a closed form that is no dearer than a fit.
  bool closed_form() const { return type == "ggx" && masking == "smith"; }
  /// Whether cos theta and alpha say all of a direction; else its azimuth counts.
  bool by_cosine() const { return slopes.centred() && slopes.alpha_x == slopes.alpha_y && slopes.correlation == 0; }
};

/// What there is to fit: Lambda of a alone for shape-invariant distributions, with their parameters (except gamma of
/// `student_t`) as they are; of a and exponent (`phong`), alpha (`gtr`, at its gamma) or gamma (`student_t`); of cos
/// theta alone for all others, and for these three too where `fixed`.
/// \throws MaterialError when the masking function has no Lambda or a formula that is none of a, the Lambda depends on
/// the azimuth by more than alpha_o and c, the parameter is outside the domain of the fit, or no code is known for the
/// form of shadowing.
FitTarget fit_target(const MaterialDescription& description, bool fixed);

/// Lambda on `lines` values of y (1: no parameter) and `per_line` of a, denser towards both ends, on so many threads.
FitSamples sample(const FitTarget& target, std::size_t per_line, std::size_t lines, int threads);

} // namespace brdfplot
