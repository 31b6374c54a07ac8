/// \file
/// Sampling a curve where it bends.
#pragma once

#include "plot/model.hpp"

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
};

struct Curve {
  std::vector<double> x;
  std::vector<double> y;
};

/// The points with which sampling begins: evenly spaced ones, and around each seed geometrically spaced ones.
std::vector<double> first_points(const CurveRequest& request);

/// Points of y(x) so close that the polyline through them is within 5e-4 of the curve, in units of the plot's size, as
/// far as halving intervals shows: each is halved until its midpoint lies on the chord, down to 1e-7 of the range (so a
/// jump is drawn as a vertical line). At the end points
/// that the polyline does not need are dropped. Deterministic.
Curve sample(const std::function<double(double)>& y, const CurveRequest& request);

} // namespace brdfplot::plot
