/// \file
/// Integration over normals by charts of their slopes.
#pragma once

#include "integrate/slope_domain.hpp"
#include "math/cubature.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace brdfplot {

/// Points of a chart: slopes and d^2 u per unit of the chart.
struct ChartPoints {
  std::vector<double> u1, u2, area;

  void resize(std::size_t n) {
    u1.resize(n);
    u2.resize(n);
    area.resize(n);
  }
};

/// An integrand over normals as one over charts. `chart(index, x, y, points)` writes the points of a chart at (x, y),
/// of which one row of a rule after the other has the same y.
template <class Chart>
ColourEstimate integrate_charts(const SlopeFrame& frame, const NormalIntegrand& f, std::size_t channels, Chart& chart,
                                const std::vector<Rectangle>& rectangles, double tolerance) {
  std::vector<Direction> normals;
  std::vector<double> values, jacobians;
  ChartPoints points;
  const auto integrand = [&](std::size_t index, const double* x, const double* y, double* out, std::size_t n) {
    normals.resize(n);
    values.resize(channels * n);
    jacobians.resize(n);
    points.resize(n);
    chart(index, std::span(x, n), std::span(y, n), points);
    frame.normals(points.u1.data(), points.u2.data(), normals.data(), n);
    // The cube of z_m underflows from slopes of 1e100 on.
    for (std::size_t k = 0; k < n; ++k) jacobians[k] = normals[k].z > 1e-95 ? frame.jacobian(normals[k]) : 0;
    f(normals, values);
    for (std::size_t c = 0; c < channels; ++c)
      for (std::size_t k = 0; k < n; ++k) {
        const double value = values[c * n + k];
        out[c * n + k] = value != 0 && jacobians[k] != 0 ? value * jacobians[k] * points.area[k] : 0;
      }
  };
  // Kinks may cut the plane into hundreds of rectangles; each must be left some to be divided with.
  const std::size_t most = std::max<std::size_t>(1000000, 2000 * rectangles.size());
  return integrate_plane(integrand, channels, rectangles, {.absolute = tolerance, .relative = 1e-14}, most);
}
} // namespace brdfplot
