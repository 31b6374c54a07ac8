/// \file
/// Sampling a curve where it bends.
#pragma once

#include "draw/model.hpp"

#include <functional>
#include <vector>

namespace brdfplot::plot {

/// What is drawn and how finely.
struct CurveRequest {
  Axis x;                    ///< swept from x.from to x.to, on its scale
  Axis y;                    ///< where the values are drawn; its range, where given, is the plot's height
  bool polar = false;        ///< (x, y) are angle and radius
  std::vector<double> seeds; ///< values of x around which there may be something narrow
  int initial = 129;         ///< evenly spaced points to begin with
  bool adaptive = true;      ///< else the evenly spaced points are all there is
  double noise = 0;          ///< values are known up to this: smaller bends are not drawn
};

struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

/// The points with which sampling begins: evenly spaced ones, and around each seed geometrically spaced ones.
std::vector<double> first_points(const CurveRequest& request);

/// Beyond the first points, a curve is evaluated at most so often.
inline constexpr int most_evaluations = 20000;

/// y at some values of x, all of which are wanted at once.
using CurveFunction = std::function<std::vector<double>(const std::vector<double>& x)>;

/// Points of y(x) so close that the polyline through them is within 5e-4 of the plot's height above or below the curve
/// (polar: of its radius, in any direction), as far as halving intervals shows: those whose midpoint lies off the chord
/// are halved, down to 1e-7 of the range, so that a jump is drawn as a vertical line. This goes in rounds, and y is
/// called once in each; a round that has more midpoints than evaluations are left takes those farthest off. A kink is
/// located where the curve extended from its left meets the curve extended from its right. At the end points that the
/// polyline does not need are dropped. Deterministic.
Curve sample(const CurveFunction& y, const CurveRequest& request);

} // namespace brdfplot::plot
