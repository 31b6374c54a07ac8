/// \file
/// What the surfaces share.
#pragma once

#include "microfacet/slopes.hpp"
#include "simulation/heightfield.hpp"
#include "simulation/surfaces/gaussian_field.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace brdfplot::simulation {

/// One sample of a random surface: one mesh, or several small ones of equal weight.
struct Realisation {
  std::vector<HeightField> fields;
  double rms_height = 0;         ///< in cells
  double correlation_length = 0; ///< in cells; 0 where there is none
};

/// Covariance of Gaussian slopes of roughness alpha: alpha^2 / 2 along each axis (Heitz 2014, Eqs. 67, 88).
inline Covariance covariance(const SlopeMap& slopes) {
  return {slopes.alpha_x * slopes.alpha_x / 2, slopes.correlation * slopes.alpha_x * slopes.alpha_y / 2,
          slopes.alpha_y * slopes.alpha_y / 2};
}

/// The slope whose unit slope is (u, v): mean + L (u, v) (Heitz 2014, Eqs. 88, 94).
inline Slope slope_at(const SlopeMap& slopes, double u, double v) {
  const auto [x, y] = slopes.slope(u, v);
  return {x, y};
}

/// The inverse of slope_at().
inline Slope unit_slope(const SlopeMap& slopes, const Slope& slope) {
  const double u = (slope.x - slopes.mean_x) / slopes.alpha_x;
  const double v = (slope.y - slopes.mean_y) / slopes.alpha_y;
  return {u, (v - slopes.correlation * u) / slopes.decorrelation()};
}

/// Slopes at unit roughness that surfaces are made with.
struct UnitSlopes {
  const char* distribution;            ///< which they are those of
  bool has_variance;                   ///< else medians tell the roughness
  double (*share_within)(double norm); ///< the share of slopes that are no larger
  double (*norm_within)(double share); ///< its inverse
};

inline constexpr UnitSlopes beckmann_slopes{"beckmann", true, [](double r) { return -std::expm1(-r * r); },
                                            [](double u) { return std::sqrt(-std::log1p(-u)); }};
inline constexpr UnitSlopes ggx_slopes{"ggx", false, [](double r) { return r * r / (1 + r * r); },
                                       [](double u) { return std::sqrt(u / (1 - u)); }};

/// The distribution named `type` with this map of slopes.
inline ModelChoice distribution_of(const std::string& type, const SlopeMap& slopes) {
  ModelChoice choice{.type = type, .values = {}};
  choice.values.set("alpha_x", slopes.alpha_x);
  choice.values.set("alpha_y", slopes.alpha_y);
  choice.values.set("correlation", slopes.correlation);
  choice.values.set("mean_slope", Vec2{slopes.mean_x, slopes.mean_y});
  return choice;
}

/// A square mesh of random heights: slopes, size and autocorrelation.
struct RandomMesh {
  SlopeMap slopes;
  double samples = 1024;
  double correlation_length = 16;
  Autocorrelation autocorrelation = Autocorrelation::gaussian;

  static std::vector<ParameterSpec> parameters();
  static RandomMesh from(const Values& values);
  std::optional<ParameterError> problem() const;
  FieldRequest request() const;
  /// The mesh of these heights, sheared by the mean slope.
  HeightField mesh(std::vector<float> heights) const;
};

} // namespace brdfplot::simulation
